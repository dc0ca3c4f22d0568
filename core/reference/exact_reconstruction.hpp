// exact_reconstruction.hpp -- independent references for moment-based transmittance (Münstermann et al.
// 2018). Reading order: point_masses (the truth and its moments), triangular_factor, bracketed_root,
// power_reference (Algorithm 1), circle_kernel and trigonometric_reference (Algorithm 2). They share neither
// code nor methods with shaders/. The shaders find the roots of a kernel that is expanded about the query in
// 1/s. The references bracket each root between nodes with which it interlaces, as theory proves, and get the
// weights by moment matching. Use long double for many queries, and boost::multiprecision::cpp_bin_float_50
// to check long double.
#pragma once
#include "core/reference/chebyshev_reference.hpp"
#include "core/reference/interval_reference.hpp"
#include "core/reference/point_masses.hpp"
#include "core/reference/power_reference.hpp"
#include "core/reference/ray_steps.hpp"
#include "core/reference/trigonometric_reference.hpp"
