// condition.hpp -- the registry of conditions under which `stress` tests a technique.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/parameters/parameters.hpp"
#include "core/ray/random_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// A ray, and the parameters for its reconstruction.
struct StressCase {
    ViewRay ray;
    ParameterValues values;
};

/// One row of the registry: everything that the program says about a condition.
struct Condition {
    std::string id;     // as in --condition
    std::string name;   // of the column in the stress map
    std::string group;  // name of neighbouring columns that vary the same thing
    std::string help;   // a sentence: what it tests
    int fragments;      // about how many a ray has, which determines the time
    std::function<StressCase(RandomNumbers& random, const Technique& technique, const ParameterValues& base)>
        make;
};

/// All conditions, group by group. Their ids are unique.
std::span<const Condition> conditions();

/// The condition with this id. Throws Error, with a list of all ids, if there is none.
const Condition& require_condition(std::string_view id);

}  // namespace momentscope
