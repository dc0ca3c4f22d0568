// tuning_attempt.hpp -- the errors of a technique over many rays with values that are tried.
#pragma once
#include <vector>

#include "core/stress/tune.hpp"

namespace momentscope {

/// Sums the errors of T over all rays, in parts of several rays.
class TuningAttempt {
public:
    /// judged: also counts failures, which takes exact arithmetic. The rays must outlive the attempt.
    TuningAttempt(const std::vector<ViewRay>& rays, const Technique& technique, const ParameterValues& values,
                  bool judged);

    /// All the work. The attempt must outlive it.
    Parts parts(const std::stop_token& stop);

    /// The errors after the work, as those of a value of a parameter.
    Trial trial(ParameterId id, float value) const;

    struct Sums {
        double squares = 0;
        long queries = 0, failures = 0, inherent = 0;
    };

private:
    const std::vector<ViewRay>& rays_;
    const Technique& technique_;
    ResolvedParameters parameters_;
    bool judged_;
    std::vector<Sums> sums_;  // of the parts
};

}  // namespace momentscope
