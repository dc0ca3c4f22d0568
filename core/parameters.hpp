// parameters.hpp -- the one registry of parameters: sliders, options, JSON keys, docs and cache invalidation
// follow from it.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/parameter_choices.hpp"

namespace momentscope {

/// The way of the data. A change invalidates its stage and all later ones.
/// shading: colours of opaque surfaces again, and then from the second pass on; the first pass knows no
/// colours.
enum class Stage { scene, opaque, moments, shading, color, composite, display, nothing };

enum class ParameterId : std::size_t {
#define PARAMETER(id, ...) id,
#include "core/parameters.def"
#undef PARAMETER
};
constexpr std::size_t PARAMETER_COUNT = 0
#define PARAMETER(...) +1
#include "core/parameters.def"
#undef PARAMETER
    ;

/// How a slider maps its way to a value; decides nothing but the looks.
enum class Scale { linear, logarithmic, toggle, choice, whole };

/// One row: everything that is said about a parameter anywhere.
struct Parameter {
    ParameterId id;
    const char* key;     // option and JSON key
    const char* symbol;  // the papers' symbol
    const char* name;
    const char* unit;  // "" for a plain number
    float minimum;
    float maximum;
    std::optional<float> default_value;  // nullopt: `auto`, the technique recommends a value
    Scale scale;
    Stage invalidates;                          // the first stage that a change makes stale
    const char* help;                           // one or two sentences: what it does and when to change it
    const char* source;                         // paper and section
    std::span<const char* const> choices = {};  // names of the values 0, 1, ...; for Scale::choice alone
};

/// Those that every picture of a scene reads, whatever the technique.
inline constexpr std::array PICTURE_PARAMETERS = {ParameterId::order, ParameterId::order_seed,
                                                  ParameterId::tone_map, ParameterId::shadows};

/// Those that pictures with shadows read, too.
inline constexpr std::array SHADOW_PARAMETERS = {ParameterId::shadow_technique, ParameterId::shadow_beta,
                                                 ParameterId::opaque_shadow,    ParameterId::shadow_size,
                                                 ParameterId::shadow_radius,    ParameterId::light_azimuth,
                                                 ParameterId::light_elevation,  ParameterId::light_distance};

/// The parameter whose values an enum of parameter_choices.def names.
template <typename Choice>
struct ParameterOf;
#define CHOICE(type, parameter, ...)                              \
    template <>                                                   \
    struct ParameterOf<type> {                                    \
        static constexpr ParameterId ID = ParameterId::parameter; \
    };
#include "core/parameter_choices.def"
#undef CHOICE

/// All parameters, in the order of ParameterId.
std::span<const Parameter> parameters();
const Parameter& parameter(ParameterId id);
const Parameter* find_parameter(std::string_view key);  // nullptr when there is none

/// A value for every parameter. A new object has all of them at their defaults. Each getter is for rows of
/// one Scale; what `set` accepts is always in the row's range.
class ParameterValues {
public:
    ParameterValues();

    /// Of a choice by name: values.get<Solver>().
    template <typename Choice>
    Choice get() const {
        return static_cast<Choice>(number_of_choice(ParameterOf<Choice>::ID));
    }

    /// The same as a number from 0, for choices that come from other registries.
    std::size_t number_of_choice(ParameterId id) const { return static_cast<std::size_t>(count(id)); }

    /// Of a switch (Scale::toggle).
    bool is_on(ParameterId id) const { return number(id) != 0; }

    /// Of a whole number.
    int count(ParameterId id) const { return static_cast<int>(number(id)); }

    /// Of a parameter that is never `auto`, in the row's unit. Throws std::bad_optional_access otherwise.
    float number(ParameterId id) const { return (*this)[id].value(); }

    /// nullopt means `auto`, which is allowed where Parameter::default_value is nullopt.
    const std::optional<float>& operator[](ParameterId id) const {
        return values_[static_cast<std::size_t>(id)];
    }

    /// Throws Error when the value is not a number within the row's range, or `auto` where there is none.
    void set(ParameterId id, std::optional<float> value);

    template <typename Choice>
    requires std::is_enum_v<Choice>
    void set(Choice choice) { set(ParameterOf<Choice>::ID, static_cast<float>(choice)); }
    void turn(ParameterId id, bool on) { set(id, on ? 1.0f : 0.0f); }

    friend bool operator==(const ParameterValues&, const ParameterValues&) = default;

private:
    std::array<std::optional<float>, PARAMETER_COUNT> values_;
};

using ParameterSettings = std::vector<std::pair<ParameterId, float>>;

/// All values at their defaults but these. Throws Error as ParameterValues::set.
ParameterValues values_with(const ParameterSettings& settings);

/// The value that a text on the command line or in a file means: a number, `auto` or one of the choices.
/// Throws Error.
std::optional<float> parse_parameter(const Parameter& row, std::string_view text);

/// The text that means a value: of a choice its name.
std::string parameter_text(const Parameter& row, std::optional<float> value);

/// The values that a row takes, for people: "a number from 0 to 1", "robust or textbook".
std::string parameter_values_text(const Parameter& row);

}  // namespace momentscope
