#include "core/report/curve_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/ray/ray_json.hpp"
#include "core/support/json_text.hpp"
#include "core/support/markup.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

namespace {

using nlohmann::ordered_json;

ordered_json moments_json(const Curve& curve) {
    if (!curve.technique->has_moments()) return nullptr;
    const MomentVector vector = curve.technique->moment_kernel().moments_of(curve.moments);
    ordered_json moments = {vector.b0};
    for (std::size_t i = 0; i < static_cast<std::size_t>(curve.technique->moment_kernel().moment_floats); ++i)
        moments.push_back(vector.b[i]);
    return moments;
}

ordered_json parameters_json(const Curve& curve) {
    ordered_json values = ordered_json::object();
    for (const Parameter& row : parameters())
        if (curve.technique->has_pixel_states() && curve.technique->uses(row.id))
            values[row.key] = parameter_text(row, curve.values[row.id]);
    if (curve.technique->uses(ParameterId::beta)) values["beta"] = curve.parameters.beta;
    if (curve.technique->uses(ParameterId::theta)) values["theta"] = curve.parameters.theta;
    if (curve.technique->uses(ParameterId::alpha)) values["alpha"] = curve.parameters.alpha;
    if (curve.technique->uses(ParameterId::solver))
        values["solver"] = curve.parameters.textbook ? "textbook" : "robust";
    return values;
}

ordered_json curve_json(const Curve& curve) {
    const auto or_null = [](bool there, const std::vector<float>& values) {
        return there && !values.empty() ? ordered_json(values) : ordered_json();
    };
    const bool bounds = curve.technique->has_bounds();
    ordered_json object = {{"technique", curve.technique->id},
                           {"parameters", parameters_json(curve)},
                           {"moments", moments_json(curve)},
                           {"depth", curve.depth},
                           {"true", curve.truth},
                           {"reconstructed", or_null(true, curve.reconstructed)},
                           {"lower", or_null(bounds, curve.beta0)},
                           {"upper", or_null(bounds, curve.beta1)}};
    if (!bounds && !curve.beta0.empty()) {
        object["beta0"] = curve.beta0;
        object["beta1"] = curve.beta1;
    }
    if (!curve.sharp_lower.empty()) {
        object["sharp_lower"] = curve.sharp_lower;
        object["sharp_upper"] = curve.sharp_upper;
    }
    return object;
}

bool have_sharp_bounds(const std::vector<Curve>& curves) {
    return std::ranges::any_of(curves, [](const Curve& curve) { return !curve.sharp_lower.empty(); });
}

// Adds two cells, which are empty if the technique has no such values.
void add_pair(std::string& text, const std::vector<float>& low, const std::vector<float>& high,
              std::size_t i) {
    if (low.empty())
        text += ",,";
    else
        fmt::format_to(std::back_inserter(text), ",{},{}", low[i], high[i]);
}

}  // namespace

std::string curves_to_json(const ViewRay& ray, const std::vector<Curve>& curves) {
    ordered_json root;
    root["ray"] = ray_to_json(ray);
    root["ray"]["total_absorbance"] = total_absorbance(ray);
    root["curves"] = ordered_json::array();
    for (const Curve& curve : curves) root["curves"].push_back(curve_json(curve));
    return json_text(root, 1) + "\n";
}

std::string curve_name(const Curve& curve, const std::vector<Curve>& curves) {
    const bool alone = std::ranges::count(curves, curve.technique, &Curve::technique) < 2;
    return alone ? curve.technique->id : configuration_text({curve.technique, curve.values});
}

std::string curves_to_csv(const std::vector<Curve>& curves) {
    const bool sharp = have_sharp_bounds(curves);
    std::string text = "technique,depth,true,reconstructed,beta0,beta1";
    text += sharp ? ",sharp_lower,sharp_upper\n" : "\n";
    for (const Curve& curve : curves) {
        const std::string name = csv_field(curve_name(curve, curves));
        for (std::size_t i = 0; i < curve.depth.size(); ++i) {
            fmt::format_to(std::back_inserter(text), "{},{},{},", name, curve.depth[i], curve.truth[i]);
            if (!curve.reconstructed.empty())
                fmt::format_to(std::back_inserter(text), "{}", curve.reconstructed[i]);
            add_pair(text, curve.beta0, curve.beta1, i);
            if (sharp) add_pair(text, curve.sharp_lower, curve.sharp_upper, i);
            text += "\n";
        }
    }
    return text;
}

std::string curves_to_table(const ViewRay& ray, const std::vector<Curve>& curves) {
    std::string text = fmt::format("{}, total absorbance {:.6g}\n", fragment_count_text(ray.fragments.size()),
                                   total_absorbance(ray));
    const auto out = std::back_inserter(text);
    for (const Curve& curve : curves) {
        const char* low = curve.technique->has_bounds() ? "lower" : "beta = 0";
        const char* high = curve.technique->has_bounds() ? "upper" : "beta = 1";
        fmt::format_to(out, "\n{}\n{:>12}{:>12}", curve_name(curve, curves), "depth", "true");
        if (!curve.reconstructed.empty()) fmt::format_to(out, "{:>15}", "reconstructed");
        if (!curve.beta0.empty()) fmt::format_to(out, "{:>12}{:>12}", low, high);
        if (!curve.sharp_lower.empty()) fmt::format_to(out, "{:>13}{:>13}", "sharp lower", "sharp upper");
        text += "\n";
        for (std::size_t i = 0; i < curve.depth.size(); ++i) {
            fmt::format_to(out, "{:>12.6f} {:>11.6f}", curve.depth[i], curve.truth[i]);
            if (!curve.reconstructed.empty()) fmt::format_to(out, " {:>14.6f}", curve.reconstructed[i]);
            if (!curve.beta0.empty())
                fmt::format_to(out, " {:>11.6f} {:>11.6f}", curve.beta0[i], curve.beta1[i]);
            if (!curve.sharp_lower.empty())
                fmt::format_to(out, " {:>12.6f} {:>12.6f}", curve.sharp_lower[i], curve.sharp_upper[i]);
            text += "\n";
        }
    }
    return text;
}

}  // namespace momentscope
