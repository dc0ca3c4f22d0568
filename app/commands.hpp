// commands.hpp -- one function per command; all throw Error.
#pragma once
#include "app/options.hpp"

namespace momentscope {

void run_explore(const Options& options);
void run_render(const Options& options);
void run_inspect(const Options& options);
void run_compare(const Options& options);
void run_figure(const Options& options);
void run_needed(const Options& options);
void run_stress_command(const Options& options);
void run_tune_command(const Options& options);
void run_chart_command(const Options& options);
void run_shadow_chart(const Options& options, const std::vector<std::string>& scenes);  // chart --shadows
void run_advise_command(const Options& options);
void run_merge_command(const Options& options);
void run_list(const std::string& what, const std::string& format);

}  // namespace momentscope
