// Our dynamics beside other programs', in one process: usage: bench_dynamics TABLE ROUNDS

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/bench/tables.h"

int main(int argc, char** argv) {
  using namespace hazumi::bench;  // NOLINT: the tables
  struct Table {
    const char* name;
    void (*print)(int);
  };
  const Table tables[] = {{"calls", PrintCalls},
                          {"work_precision", PrintWorkPrecision},
                          {"scaling", PrintScaling},
                          {"stability", PrintStability},
                          {"modelling", PrintModelling},
                          {"springs", PrintSprings},
                          {"spring_stability", PrintSpringStability},
                          {"contact", PrintContact}};
  for (const Table& table : tables) {
    if (argc != 3 || std::strcmp(argv[1], table.name) != 0) continue;
    table.print(std::atoi(argv[2]));
    return 0;
  }
  std::fprintf(stderr, "usage: %s TABLE ROUNDS, the table one of", argv[0]);
  for (const Table& table : tables) std::fprintf(stderr, " %s", table.name);
  std::fputc('\n', stderr);
  return 2;
}
