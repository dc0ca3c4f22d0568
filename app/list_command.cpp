#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/command_line_page.hpp"
#include "app/gl_context.hpp"
#include "app/ignored_options.hpp"
#include "app/options.hpp"
#include "app/terminal.hpp"
#include "core/figures/figure.hpp"
#include "core/render/transparency.hpp"
#include "core/report/techniques_page.hpp"
#include "core/scene/scenes.hpp"
#include "core/stress/condition.hpp"
#include "core/support/error.hpp"
#include "core/support/json_text.hpp"
#include "core/support/markup.hpp"
#include "ui/commands/commands.hpp"

namespace momentscope {

namespace {

using nlohmann::json;

// Bits per pixel.
json json_of_bits(const Technique& technique, int bits) {
    return technique.is_truth() && bits == 0 ? json("unbounded") : json(bits);
}

json list_techniques() {
    json rows = json::array();
    for (const Technique& t : techniques()) {
        json keys = json::array();
        for (const ParameterId id : t.parameters) keys.push_back(parameter(id).key);
        rows.push_back({{"id", t.id},
                        {"name", t.name},
                        {"stored_bits", json_of_bits(t, stored_bits(t, {}))},
                        {"bits_with_factor", json_of_bits(t, bits_with_factor(t, {}))},
                        {"geometry_passes", t.geometry_passes},
                        {"order_dependent", t.order_dependent},
                        {"has_bounds", t.has_bounds()},
                        {"recommended_bias", t.has_moments() ? json(t.moments().recommended_bias) : json()},
                        {"parameters", keys},
                        {"source", t.source},
                        {"description", t.description}});
    }
    return rows;
}

json list_scenes() {
    json rows = json::array();
    for (const SceneEntry& entry : scene_entries())
        rows.push_back({{"id", entry.id}, {"description", entry.description}});
    return rows;
}

json list_parameters() {
    json rows = json::array();
    for (const Parameter& p : parameters())
        rows.push_back(
            {{"key", p.key},
             {"symbol", p.symbol},
             {"name", p.name},
             {"unit", p.unit},
             {"minimum", p.minimum},
             {"maximum", p.maximum},
             {"choices", p.choices},
             {"default", p.default_value && p.choices.empty() ? json(*p.default_value)
                                                              : json(parameter_text(p, p.default_value))},
             {"help", p.help},
             {"source", p.source}});
    return rows;
}

std::string cell(const json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return fmt::format("{:g}", value.get<double>());
    if (value.is_null()) return "-";
    if (!value.is_array()) return value.dump();
    std::string joined;
    for (const json& entry : value) joined += (joined.empty() ? "" : " ") + entry.get<std::string>();
    return joined.empty() ? "-" : joined;
}

// The commands of the window.
json list_commands() {
    json rows = json::array();
    for (const ui::Command& command : ui::commands())
        rows.push_back(
            {{"id", command.id}, {"name", command.name}, {"keys", command.keys}, {"help", command.help}});
    return rows;
}

// The number of characters of a UTF-8 text on the screen; symbols are Greek.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

void print_table(const json& rows, const std::vector<std::string>& columns) {
    for (const json& row : rows) {
        std::string line;
        for (const std::string& column : columns) {
            std::size_t widest = 0;
            for (const json& other : rows) widest = std::max(widest, width_of(cell(other[column])));
            const std::string text = cell(row[column]);
            line += text;
            if (column != columns.back()) line += std::string(widest - width_of(text) + 2, ' ');
        }
        print(line + "\n");
    }
}

void print_markdown(const json& rows, const std::vector<std::string>& columns) {
    const auto print_row = [&](auto cell_of) {
        std::string line = "|";
        for (const std::string& column : columns) line += fmt::format(" {} |", cell_of(column));
        print(line + "\n");
    };
    print_row([](const std::string& column) { return column; });
    print_row([](const std::string&) { return "---"; });
    for (const json& row : rows)
        print_row([&](const std::string& column) { return markdown_cell(cell(row[column])); });
}

struct Listing {
    json rows;
    std::vector<std::string> columns;  // columns of the table
};

json list_conditions() {
    json rows = json::array();
    for (const Condition& condition : conditions())
        rows.push_back({{"id", condition.id},
                        {"group", condition.group},
                        {"name", condition.name},
                        {"help", condition.help}});
    return rows;
}

json list_figures() {
    json rows = json::array();
    for (const Figure& figure : figures())
        rows.push_back({{"id", figure.id}, {"title", figure.title}, {"source", figure.source}});
    return rows;
}

Listing listing_of(const std::string& what) {
    if (what == "techniques")
        return {list_techniques(),
                {"id", "stored_bits", "bits_with_factor", "geometry_passes", "name", "source"}};
    if (what == "scenes") return {list_scenes(), {"id", "description"}};
    if (what == "conditions") return {list_conditions(), {"id", "group", "help"}};
    if (what == "parameters")
        return {list_parameters(), {"key", "symbol", "minimum", "maximum", "default", "name"}};
    if (what == "figures") return {list_figures(), {"id", "title", "source"}};
    if (what == "commands") return {list_commands(), {"id", "keys", "name"}};
    throw Error(fmt::format(
        "There is no list '{}'; use techniques, scenes, parameters, conditions, figures, options or commands.",
        what));
}

// The options of the command line, with the texts of --help.
Listing list_options(const CLI::App& line) {
    json rows = json::array();
    for (const Command& command : command_rows())
        for (const CLI::Option* option : line.get_subcommand(command.name)->get_options())
            rows.push_back({{"command", command.name},
                            {"option", option->get_name()},
                            {"help", option->get_description()},
                            {"required", option->get_required()}});
    return {rows, {"command", "option", "help"}};
}

// Asks the chosen GL. The sentences of techniques that it cannot draw stand in a column of their own.
void add_availability(Listing& listing) {
    const auto context = make_headless_context({16, 16});
    const Capabilities gl = capabilities();
    for (json& row : listing.rows) {
        const std::string why = why_unavailable(require_technique(row["id"].get<std::string>()), gl);
        row["on this GL"] = why.empty() ? "runs" : why;
    }
    listing.columns = {"id", "name", "on this GL"};
}

class ListCommand : public ParsedCommand {
public:
    explicit ListCommand(CLI::App& app) : ParsedCommand(app) {
        app.add_option(
               "what", what_,
               "techniques, scenes, parameters, conditions, figures, options or commands (of the window)")
            ->required();
        app.add_option("--format", format_, "table, json or markdown [table]");
        add_gl(app)->description(
            fmt::format("for techniques: also say which of them a GL draws: {}", headless_gl_keys()));
    }

    void refuse_ignored() const override {
        refuse_ignored_options(app(), {{"--gl", what_ != "techniques", "with this list"}});
    }

    void run() const override {
        if (format_ == "markdown" && what_ == "techniques") return print(techniques_page());
        if (format_ == "markdown" && what_ == "options") return print(command_line_page(*app().get_parent()));
        if (format_ != "table" && format_ != "json" && format_ != "markdown")
            throw Error(fmt::format("There is no format '{}'; use table, json or markdown.", format_));
        Listing listing = what_ == "options" ? list_options(*app().get_parent()) : listing_of(what_);
        if (app().count("--gl") > 0) add_availability(listing);
        if (format_ == "json")
            print(json_text(listing.rows, 2) + "\n");
        else if (format_ == "markdown")
            print_markdown(listing.rows, listing.columns);
        else
            print_table(listing.rows, listing.columns);
    }

private:
    std::string what_;
    std::string format_ = "table";
};

}  // namespace

std::unique_ptr<ParsedCommand> add_list(CLI::App& app) {
    return std::make_unique<ListCommand>(app);
}

}  // namespace momentscope
