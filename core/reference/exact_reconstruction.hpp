// exact_reconstruction.hpp -- independent references for moment-based transmittance (Muenstermann et al.
// 2018). Reading order: point_masses (the truth and its moments), triangular_factor, bracketed_root,
// power_reference (Algorithm 1), circle_kernel and trigonometric_reference (Algorithm 2). Nothing here is
// shared with shaders/, nor is the method: the product roots a kernel expanded about the query in 1/s; these
// bracket each root between the nodes that theory says it interlaces with, and match the moments for the
// weights. Use long double in bulk, and boost::multiprecision::cpp_bin_float_50 to judge long double.
#pragma once
#include "core/reference/point_masses.hpp"
#include "core/reference/power_reference.hpp"
#include "core/reference/trigonometric_reference.hpp"
