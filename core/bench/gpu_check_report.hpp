// gpu_check_report.hpp -- a check of a GL as text and as JSON, for people who attach it to a report.
#pragma once
#include <string>

#include "core/bench/gpu_check.hpp"

namespace momentscope {

/// What this GL is and has, what each technique does on it, and what the result means. kind: how the context
/// was made, such as "osmesa".
std::string gpu_check_text(const GpuCheck& check, const std::string& kind);

/// The same as JSON (docs/gl.md).
std::string gpu_check_json(const GpuCheck& check, const std::string& kind);

/// One sentence: whether this GL computes what C++ computes, and what it means if it does not.
std::string gpu_check_verdict(const GpuCheck& check);

}  // namespace momentscope
