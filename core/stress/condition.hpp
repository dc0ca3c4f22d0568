// condition.hpp -- the registry of conditions under which `stress` tries a technique.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/parameters.hpp"
#include "core/ray/random_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// A ray and the parameters to reconstruct it with.
struct StressCase {
    ViewRay ray;
    ParameterValues values;
};

/// One row: everything that is said about a condition anywhere.
struct Condition {
    std::string id;     // as in --condition
    std::string name;   // of the column
    std::string group;  // neighbouring columns that vary one thing
    std::string help;   // a sentence: what it tries
    int fragments;      // about how many a ray has: what it costs
    std::function<StressCase(RandomNumbers& random, const Technique& technique, const ParameterValues& base)>
        make;
};

/// All conditions, group by group; ids are unique.
std::span<const Condition> conditions();

/// The condition with that id. Throws Error that lists the ids.
const Condition& require_condition(std::string_view id);

}  // namespace momentscope
