// parameters.hpp -- the registry of parameters. Sliders, options, JSON keys and docs follow from it, and also
// which stages a change makes stale.
#pragma once
#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/parameters/parameter_choices.hpp"

namespace momentscope {

/// The stages of the pipeline, in the order in which they run. A change makes its stage and all later ones
/// stale. nothing: no stage is stale. shading: opaque surfaces are shaded again, and then everything from the
/// second pass on runs again; the first pass runs again only if it stores colours.
enum class Stage { scene, opaque, moments, shading, color, composite, display, nothing };

enum class ParameterId : std::size_t {
#define PARAMETER(id, ...) id,
#include "core/parameters/parameters.def"
#undef PARAMETER
};
constexpr std::size_t PARAMETER_COUNT =
    std::initializer_list<ParameterId>{
#define PARAMETER(id, ...) ParameterId::id,
#include "core/parameters/parameters.def"
#undef PARAMETER
    }
        .size();

/// What kind of number a parameter is, and how its slider looks. toggle: 0 or 1. choice: an index into the
/// names of its values. whole: a whole number.
enum class Scale { linear, logarithmic, toggle, choice, whole };

/// One row of the registry: everything that the program says about a parameter.
struct Parameter {
    ParameterId id;
    const char* key;     // key of options and JSON
    const char* symbol;  // symbol in the papers
    const char* name;
    const char* unit;  // "" if it has no unit
    float minimum;
    float maximum;
    std::optional<float> default_value;  // nullopt: `auto`, a value of the technique or of the scene
    Scale scale;
    Stage invalidates;                          // first stage that a change makes stale
    const char* help;                           // a few sentences: what it does, when to change it
    const char* source;                         // paper and section
    std::span<const char* const> choices = {};  // names of the values 0, 1, ...; only for Scale::choice
};

/// Parameters that every picture of a scene reads, whatever the technique.
inline constexpr std::array PICTURE_PARAMETERS = {ParameterId::order, ParameterId::order_seed,
                                                  ParameterId::tone_map, ParameterId::shadows};

/// Parameters that pictures with shadows read in addition.
inline constexpr std::array SHADOW_PARAMETERS = {ParameterId::shadow_technique, ParameterId::shadow_beta,
                                                 ParameterId::opaque_shadow,    ParameterId::shadow_size,
                                                 ParameterId::shadow_radius,    ParameterId::light_azimuth,
                                                 ParameterId::light_elevation,  ParameterId::light_distance};

/// The parameter that an enum of parameter_choices.def belongs to: ParameterOf<Solver>::ID is
/// ParameterId::solver.
template <typename Choice>
struct ParameterOf;
#define CHOICE(type, parameter, ...)                              \
    template <>                                                   \
    struct ParameterOf<type> {                                    \
        static constexpr ParameterId ID = ParameterId::parameter; \
    };
#include "core/parameters/parameter_choices.def"
#undef CHOICE

/// All parameters, in the order of ParameterId.
std::span<const Parameter> parameters();
const Parameter& parameter(ParameterId id);
const Parameter* find_parameter(std::string_view key);  // nullptr if there is none

/// A value for every parameter. A new object has the default values. get and number_of_choice are for rows
/// with Scale::choice, is_on for Scale::toggle, count for whole numbers; number and [] are for all rows.
/// Values that `set` accepts are always in the range of their row.
class ParameterValues {
public:
    ParameterValues();

    /// The value of a choice, by the enum of parameter_choices.def: values.get<Solver>().
    template <typename Choice>
    Choice get() const {
        return static_cast<Choice>(number_of_choice(ParameterOf<Choice>::ID));
    }

    /// The value of a choice as an index from 0, for choices without an enum: their names are the rows of
    /// another registry, as with shadow_technique.
    std::size_t number_of_choice(ParameterId id) const { return static_cast<std::size_t>(count(id)); }

    /// The value of a switch (Scale::toggle).
    bool is_on(ParameterId id) const { return number(id) != 0; }

    /// The value of a whole number.
    int count(ParameterId id) const { return static_cast<int>(number(id)); }

    /// The value of a parameter, in the unit of its row. Throws std::bad_optional_access if the value is
    /// `auto`.
    float number(ParameterId id) const { return (*this)[id].value(); }

    /// The value, or nullopt for `auto`. Only parameters without a Parameter::default_value can be `auto`.
    const std::optional<float>& operator[](ParameterId id) const {
        return values_[static_cast<std::size_t>(id)];
    }

    /// Throws Error if the value is not a number in the range of the row, if the row needs a whole number and
    /// the value is not one, or if it is `auto` and the row has a default value.
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

/// The default values except for these settings. Throws Error as ParameterValues::set does.
ParameterValues values_with(const ParameterSettings& settings);

/// Reads a value from a text on the command line or in a file: a number, `auto` (nullopt), on, off, true or
/// false for a switch, or the name of a choice. Throws Error if it is none of these. It does not check the
/// range; ParameterValues::set does.
std::optional<float> parse_parameter(const Parameter& row, std::string_view text);

/// The text of a value; for a choice, its name.
std::string parameter_text(const Parameter& row, std::optional<float> value);

/// The values that a row accepts, as text for people: "a number from 0 to 1", "robust or textbook".
std::string parameter_values_text(const Parameter& row);

}  // namespace momentscope
