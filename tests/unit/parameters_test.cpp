// parameters_test.cpp -- values in their ranges, texts of values, and the stages that a change makes stale.
#include "core/parameters/parameters.hpp"
#include "core/render/view.hpp"
#include "tests/unit/expect_error.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace momentscope;

namespace {

constexpr float NO_NUMBER = std::numeric_limits<float>::quiet_NaN();
constexpr float ENDLESS = std::numeric_limits<float>::infinity();

TEST(ParameterValues, StartAtTheirDefaults) {
    const ParameterValues values;
    for (const Parameter& row : parameters()) EXPECT_EQ(values[row.id], row.default_value) << row.key;
    EXPECT_EQ(values[ParameterId::alpha], std::nullopt);
}

/// Every value of an enum has a name, and the name gives the value.
template <typename Choice>
void expect_named(const std::vector<Choice>& all) {
    const Parameter& row = parameter(ParameterOf<Choice>::ID);
    SCOPED_TRACE(row.key);
    ASSERT_EQ(row.scale, Scale::choice);
    ASSERT_EQ(row.choices.size(), all.size());
    EXPECT_EQ(row.minimum, 0);
    EXPECT_EQ(row.maximum, static_cast<float>(all.size() - 1));
    for (std::size_t i = 0; i < all.size(); ++i) {
        ParameterValues values;
        values.set(row.id, parse_parameter(row, row.choices[i]));
        EXPECT_EQ(values.get<Choice>(), all[i]);
        ParameterValues typed;
        typed.set(all[i]);
        EXPECT_EQ(typed, values);
    }
}

TEST(ParameterValues, NameTheirChoices) {
#define VALUE(enumerator, text) enumerator
#define CHOICE(type, parameter, ...)       \
    {                                      \
        using enum type;                   \
        expect_named<type>({__VA_ARGS__}); \
    }
#include "core/parameters/parameter_choices.def"
#undef CHOICE
#undef VALUE
    EXPECT_EQ(ParameterValues().get<Solver>(), Solver::robust);
    ParameterValues values;
    values.set(ParameterId::read_format, parse_parameter(parameter(ParameterId::read_format), "nlqm64"));
    EXPECT_EQ(values.get<ReadFormat>(), ReadFormat::nlqm64);
}

TEST(ParameterValues, AreReadAsWhatTheyAre) {
    ParameterValues values;
    EXPECT_FALSE(values.is_on(ParameterId::shadows));
    values.turn(ParameterId::shadows, true);
    EXPECT_TRUE(values.is_on(ParameterId::shadows));
    values.set(ParameterId::nodes, 7.0f);
    EXPECT_EQ(values.count(ParameterId::nodes), 7);
    EXPECT_EQ(values.number(ParameterId::beta), 0.25f);
    EXPECT_THROW(values.number(ParameterId::alpha), std::bad_optional_access) << "it is automatic";
}

TEST(ParameterValues, TakeBothEndsOfTheRangeAndNothingBeyond) {
    for (const Parameter& row : parameters()) {
        SCOPED_TRACE(row.key);
        ParameterValues values;
        for (const float end : {row.minimum, row.maximum}) {
            values.set(row.id, end);
            EXPECT_EQ(values[row.id], end);
        }
        const ParameterValues before = values;
        const float below = std::nextafter(row.minimum, -ENDLESS);
        const float above = std::nextafter(row.maximum, ENDLESS);
        for (const float refused : {below, above, NO_NUMBER, ENDLESS, -ENDLESS})
            expect_error([&] { values.set(row.id, refused); }, std::string("--") + row.key);
        EXPECT_EQ(values, before);  // a refused value changed nothing
    }
}

TEST(ParameterValues, AreAutomaticOnlyWhereThereIsNoStandard) {
    for (const Parameter& row : parameters()) {
        ParameterValues values;
        if (row.default_value) {
            expect_error([&] { values.set(row.id, std::nullopt); }, std::string("--") + row.key);
            EXPECT_EQ(values[row.id], row.default_value);
        } else {
            values.set(row.id, row.maximum);
            values.set(row.id, std::nullopt);
            EXPECT_EQ(values[row.id], std::nullopt);
        }
    }
}

TEST(ParameterValues, AreEqualWhenEveryValueIs) {
    for (const Parameter& row : parameters()) {
        ParameterValues a;
        ParameterValues b;
        EXPECT_EQ(a, b);
        a.set(row.id, row.maximum);
        b.set(row.id, row.minimum);
        EXPECT_NE(a, b) << row.key;
        b.set(row.id, row.maximum);
        EXPECT_EQ(a, b) << row.key;
    }
    ParameterValues zero_bias;
    zero_bias.set(ParameterId::alpha, 0.0f);
    EXPECT_NE(zero_bias, ParameterValues());  // `auto` is not 0
}

TEST(ParseParameter, ReadsNumbersAndAuto) {
    const Parameter& alpha = parameter(ParameterId::alpha);
    EXPECT_EQ(parse_parameter(alpha, "auto"), std::nullopt);
    EXPECT_EQ(parse_parameter(alpha, "5e-7"), 5e-7f);
    EXPECT_EQ(parse_parameter(alpha, ".5"), 0.5f);
    EXPECT_EQ(parse_parameter(alpha, "0"), 0.0f);
    EXPECT_EQ(parse_parameter(alpha, "-1"), -1.0f);  // a number; set() checks the range
}

TEST(ParseParameter, RefusesWhatIsNoNumber) {
    const Parameter& beta = parameter(ParameterId::beta);
    for (const char* text :
         {"", " ", "x", "0.5x", "0.5 ", " 0.5", "0,5", "0.5.5", "1e", "--1", "Auto", "1e999", "0x1p-1"})
        expect_error([&] { parse_parameter(beta, text); }, "--beta");
    expect_error([] { parse_parameter(parameter(ParameterId::alpha), "x"); }, "or auto");
    try {
        parse_parameter(beta, "x");
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find("auto"), std::string::npos);  // beta has no auto
    }
}

TEST(ParseParameter, NoTextGetsNaNOrInfinityIntoTheValues) {
    for (const char* text : {"nan", "-nan", "inf", "-inf", "infinity", "1e39"}) {
        ParameterValues values;
        const auto typed = [&] {
            values.set(ParameterId::beta, parse_parameter(parameter(ParameterId::beta), text));
        };
        expect_error(typed, "--beta");
        EXPECT_EQ(values, ParameterValues()) << text;
    }
}

/// A view of a scene with one technique.
View view_with(const char* technique) {
    View view;
    view.size = {320, 200};
    view.technique = &require_technique(technique);
    return view;
}

View changed(View view, ParameterId id) {
    const Parameter& row = parameter(id);
    view.parameters.set(id, row.default_value == row.maximum ? row.minimum : row.maximum);
    return view;
}

View with(View view, Renormalization choice) {
    view.parameters.set(choice);
    return view;
}

Stage stale_after_changing(const char* technique, ParameterId id) {
    const View view = view_with(technique);
    return first_stale_stage(view, changed(view, id));
}

TEST(FirstStaleStage, IsNothingWhenNothingChanged) {
    for (const Technique& technique : techniques()) {
        const View view = view_with(technique.id);
        EXPECT_EQ(first_stale_stage(view, view), Stage::nothing) << technique.id;
        EXPECT_EQ(first_stale_stage(changed(view, ParameterId::beta), changed(view, ParameterId::beta)),
                  Stage::nothing);
    }
}

TEST(FirstStaleStage, FollowsWhatATechniqueReads) {
    for (const char* technique :
         {"power4-32", "power6-32", "power8-32", "trig2-32", "trig3-32", "trig4-32"}) {
        SCOPED_TRACE(technique);
        const bool circle = technique[0] == 't';
        EXPECT_EQ(stale_after_changing(technique, ParameterId::beta), Stage::color);
        EXPECT_EQ(stale_after_changing(technique, ParameterId::alpha), Stage::color);
        EXPECT_EQ(stale_after_changing(technique, ParameterId::theta),
                  circle ? Stage::moments : Stage::nothing);
        const View view = view_with(technique);
        EXPECT_EQ(first_stale_stage(view, with(view, Renormalization::off)), Stage::composite);
        EXPECT_EQ(first_stale_stage(view, with(view, Renormalization::uncertain)), Stage::color)
            << "the second pass sums what is uncertain";
        EXPECT_EQ(stale_after_changing(technique, ParameterId::estimate), Stage::color);
        EXPECT_EQ(stale_after_changing(technique, ParameterId::ends), Stage::moments);
        EXPECT_EQ(stale_after_changing(technique, ParameterId::interval), Stage::moments);
        EXPECT_EQ(stale_after_changing(technique, ParameterId::opacity), Stage::nothing);  // not in scenes
        EXPECT_EQ(stale_after_changing(technique, ParameterId::tone_map), Stage::display);
    }
    for (const Parameter& row : parameters()) {  // the truth reads what every picture reads, and nothing else
        const bool of_every_picture =
            std::ranges::find(PICTURE_PARAMETERS, row.id) != PICTURE_PARAMETERS.end();
        EXPECT_EQ(stale_after_changing("sorted", row.id), of_every_picture ? row.invalidates : Stage::nothing)
            << row.key;
    }
    EXPECT_EQ(parameter(ParameterId::order).invalidates, Stage::moments);
    EXPECT_EQ(stale_after_changing("mt", ParameterId::beta), Stage::moments) << "a first pass may read it";
}

TEST(FirstStaleStage, IsTheEarliestOfSeveral) {
    const View view = view_with("trig3-32");
    const View composite = with(view, Renormalization::off);
    const View color = changed(composite, ParameterId::beta);
    const View moments = changed(color, ParameterId::theta);
    EXPECT_EQ(first_stale_stage(view, color), Stage::color);
    EXPECT_EQ(first_stale_stage(view, moments), Stage::moments);
    EXPECT_EQ(first_stale_stage(moments, view), Stage::moments);
}

TEST(FirstStaleStage, IsOpaqueWhenCameraOrSizeChangeOrNothingWasDrawn) {
    const View view = view_with("power6-32");
    const auto stale = [&](const auto& change) {
        View after = with(view, Renormalization::off);  // a later stage must not hide it
        change(after);
        return first_stale_stage(view, after);
    };
    EXPECT_EQ(stale([](View& v) { v.camera.target.y += 1e-6f; }), Stage::opaque);
    EXPECT_EQ(stale([](View& v) { v.camera.distance *= 2.0f; }), Stage::opaque);
    EXPECT_EQ(stale([](View& v) { v.camera.azimuth += 0.1f; }), Stage::opaque);
    EXPECT_EQ(stale([](View& v) { v.camera.elevation += 0.1f; }), Stage::opaque);
    EXPECT_EQ(stale([](View& v) { v.camera.field_of_view += 0.1f; }), Stage::opaque);
    EXPECT_EQ(stale([](View& v) { v.size.x += 1; }), Stage::opaque);
    EXPECT_EQ(stale([](View& v) { v.size.y += 1; }), Stage::opaque);
    EXPECT_EQ(first_stale_stage(View(), view), Stage::opaque);
}

TEST(FirstStaleStage, IsMomentsForAnotherTechnique) {
    for (const Technique& a : techniques())
        for (const Technique& b : techniques())
            EXPECT_EQ(first_stale_stage(view_with(a.id), view_with(b.id)),
                      &a == &b ? Stage::nothing : Stage::moments)
                << a.id << " to " << b.id;
}

}  // namespace
