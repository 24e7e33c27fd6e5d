// libjpeg reports errors by longjmp: between setjmp and its calls nothing lives on the stack that
// needs a destructor. Colour profiles and orientation marks are not followed, as in glTF.

#include <cstdio>
// jpeglib.h needs the declarations of stdio.
#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>

#include "engine/picture/decode.h"
#include "engine/picture/image.h"

namespace hazumi {
namespace {

// A progressive file may repeat itself without end, each scan costing the whole picture.
constexpr int kMostScans = 300;

struct DecodeJob {
  jpeg_decompress_struct cinfo{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf on_error{};
  char problem[JMSG_LENGTH_MAX] = "";
  std::string size_problem;
  Image image;
  std::vector<std::uint8_t> row;
};

DecodeJob* JobOf(j_common_ptr cinfo) { return static_cast<DecodeJob*>(cinfo->client_data); }

void OnError(j_common_ptr cinfo) {
  DecodeJob* job = JobOf(cinfo);
  cinfo->err->format_message(cinfo, job->problem);
  std::longjmp(job->on_error, 1);
}

// Odd bytes between markers harm nothing; an early end or damaged data leave grey areas.
void OnMessage(j_common_ptr cinfo, int level) {
  if (level >= 0) return;
  const int code = cinfo->err->msg_code;
  if (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE) {
    OnError(cinfo);
  }
}

void OnOutput(j_common_ptr) {}

void OnProgress(j_common_ptr cinfo) {
  DecodeJob* job = JobOf(cinfo);
  if (job->cinfo.input_scan_number <= kMostScans) return;
  std::snprintf(job->problem, sizeof(job->problem), "more than %d scans", kMostScans);
  std::longjmp(job->on_error, 1);
}

void InstallHandlers(DecodeJob* job) {
  job->cinfo.err = jpeg_std_error(&job->errors);
  job->errors.error_exit = OnError;
  job->errors.emit_message = OnMessage;
  job->errors.output_message = OnOutput;
  job->cinfo.client_data = job;
}

// `c`, `m`, `y` and `k` as Adobe stores them: 255 is no ink.
void CopyCmyk(const std::uint8_t* from, int width, std::uint8_t* to) {
  for (int x = 0; x < width; ++x, from += 4, to += 4) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<std::uint8_t>(from[i] * from[3] / 255);
    to[3] = 255;
  }
}

void ReadRows(DecodeJob* job) {
  jpeg_decompress_struct& cinfo = job->cinfo;
  const size_t stride = static_cast<size_t>(job->image.width) * 4;
  while (cinfo.output_scanline < cinfo.output_height) {
    std::uint8_t* to = job->image.rgba.data() + cinfo.output_scanline * stride;
    JSAMPROW row = cinfo.out_color_space == JCS_CMYK ? job->row.data() : to;
    jpeg_read_scanlines(&cinfo, &row, 1);
    if (row != to) CopyCmyk(row, job->image.width, to);
  }
}

bool Run(DecodeJob* job, std::span<const std::uint8_t> file) {
  if (setjmp(job->on_error) != 0) return false;
  jpeg_decompress_struct& cinfo = job->cinfo;
  jpeg_create_decompress(&cinfo);
  job->progress.progress_monitor = OnProgress;
  cinfo.progress = &job->progress;
  cinfo.mem->max_memory_to_use = 1L << 29;
  jpeg_mem_src(&cinfo, file.data(), file.size());
  jpeg_read_header(&cinfo, TRUE);
  job->size_problem = ComplaintOnSize(cinfo.image_width, cinfo.image_height);
  if (!job->size_problem.empty()) return false;
  const bool is_cmyk = cinfo.num_components == 4;
  cinfo.out_color_space = is_cmyk ? JCS_CMYK : JCS_EXT_RGBA;
  cinfo.dct_method = JDCT_ISLOW;
  jpeg_start_decompress(&cinfo);
  job->image = Image(int(cinfo.output_width), int(cinfo.output_height));
  job->row.resize(size_t{4} * cinfo.output_width);
  ReadRows(job);
  jpeg_finish_decompress(&cinfo);
  return true;
}

}  // namespace

Result<Image> DecodeJpeg(std::span<const std::uint8_t> file) {
  DecodeJob job;
  InstallHandlers(&job);
  const bool read = Run(&job, file);
  jpeg_destroy_decompress(&job.cinfo);
  if (read) return std::move(job.image);
  if (!job.size_problem.empty()) return Error{ErrorCode::kSyntax, "", "", job.size_problem};
  return Error{ErrorCode::kSyntax, "", "",
               std::string("the JPEG is damaged or cut off (") + job.problem +
                   "); save it anew with another program"};
}

}  // namespace hazumi
