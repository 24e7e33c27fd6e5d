#include "engine/bake/walk/region_estimates.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

void RegionEstimates::BeginIslands(double t) {
  for (Record& record : estimates_) {
    if (!record.is_beyond) record.within_until = t;
  }
}

void RegionEstimates::Add(double t, const std::vector<double>& errors) {
  HAZUMI_ASSERT(errors.size() == estimates_.size());
  for (size_t place = 0; place < errors.size(); ++place) {
    HAZUMI_ASSERT(errors[place] >= 0.0);
    Record& record = estimates_[place];
    record.error = std::max(record.error, errors[place]);
    record.is_beyond |= errors[place] > regions_.ToleranceOf(place);
    if (!record.is_beyond) {
      record.within = record.error;
      record.within_until = t;
    }
  }
}

void RegionEstimates::NoteTimeStepping(const std::vector<Coordinate>& hinges, double t) {
  for (const Coordinate c : hinges) {
    double& from = estimates_[regions_.PlaceOf(c)].time_stepping_from;
    from = std::min(from, t);
  }
}

void RegionEstimates::NoteBranches(const std::vector<Coordinate>& hinges, double t) {
  for (const Coordinate c : hinges) {
    double& from = estimates_[regions_.PlaceOf(c)].branches_from;
    from = std::min(from, t);
  }
}

RegionEstimates::Estimate RegionEstimates::Of(size_t place) const {
  const Record& record = estimates_[place];
  if (record.is_beyond && std::isfinite(record.time_stepping_from)) {
    return {record.within, std::min(record.within_until, record.time_stepping_from),
            record.branches_from};
  }
  return {record.error, record.time_stepping_from, record.branches_from};
}

}  // namespace hazumi
