// curve_bench.cpp -- measures the cost of the plot on one core: curves of 512 depths with both bounds, from
// moments to absorbance, as wide as the CPU allows. For comparison, it evaluates the same depths one by one
// with either solver, like published code.
#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <map>
#include <random>
#include <string>

#include "core/inspect/curve.hpp"

namespace momentscope {
namespace {

constexpr std::size_t SAMPLES = 512;

ViewRay five_fragments() {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> depth(-1.0f, 1.0f);
    std::uniform_real_distribution<float> opacity(0.05f, 0.95f);
    ViewRay ray;
    for (int i = 0; i < 5; ++i) ray.fragments.push_back({.depth = depth(random), .opacity = opacity(random)});
    return ray;
}

// The work of the window when a ray changes: the functions of every technique that has one, from the
// fragments.
void run_everything(benchmark::State& state) {
    const ViewRay ray = five_fragments();
    const std::vector<float> depths = even_depths(SAMPLES);
    for (auto _ : state)
        for (const Technique& technique : techniques())
            if (has_function(technique)) benchmark::DoNotOptimize(sample_curve(ray, technique, {}, depths));
}

void run_pixel_state(benchmark::State& state, const Technique& technique) {
    const ViewRay ray = five_fragments();
    const std::vector<float> depths = even_depths(SAMPLES);
    for (auto _ : state) benchmark::DoNotOptimize(sample_curve(ray, technique, {}, depths));
}

struct Work {
    const Technique* technique;
    ResolvedParameters parameters;
    MomentVector moments;
};

Work work_for(const Technique& technique) {
    const ResolvedParameters parameters = resolve({}, technique);
    return {&technique, parameters, sum_moments(five_fragments(), technique, parameters)};
}

void evaluate(const Work& work, const std::vector<float>& depths, std::vector<float> (&curves)[3]) {
    work.technique->moment_kernel().evaluate(work.moments, settings_of(work.parameters), depths,
                                             {curves[0], curves[1], curves[2]});
    benchmark::DoNotOptimize(curves[0].data());
    benchmark::ClobberMemory();
}

void run(benchmark::State& state, const std::vector<Work>& all) {
    const std::vector<float> depths = even_depths(SAMPLES);
    std::vector<float> curves[3];
    for (auto& curve : curves) curve.resize(SAMPLES);
    for (auto _ : state)
        for (const Work& work : all) evaluate(work, depths, curves);
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * SAMPLES * all.size()));
}

// The same number of pixels, each at one depth, with all work of a fragment's second pass.
void run_pixels(benchmark::State& state, const Work& work) {
    const ReconstructionSettings settings = settings_of(work.parameters);
    const std::vector<float> depths = even_depths(SAMPLES);
    const std::vector<MomentVector> moments(SAMPLES, work.moments);
    std::vector<float> fractions(SAMPLES);
    for (auto _ : state) {
        work.technique->moment_kernel().fractions(moments, settings, depths, fractions);
        benchmark::DoNotOptimize(fractions.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * SAMPLES));
}

// One call per depth, with all work of a fragment's second pass.
void run_scalar(benchmark::State& state, Work work, bool textbook) {
    work.parameters.textbook = textbook;
    const ReconstructionSettings settings = settings_of(work.parameters);
    const std::vector<float> depths = even_depths(SAMPLES);
    for (auto _ : state)
        for (const float depth : depths)
            benchmark::DoNotOptimize(work.technique->moment_kernel().fraction(work.moments, settings, depth));
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * SAMPLES));
}

// Prints nanoseconds per reconstruction, and how many times slower the textbook solver is than the vectorised
// one.
class Table : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs)
            if (run.counters.count("items_per_second") > 0)
                nanoseconds_[run.benchmark_name()] = 1e9 / run.counters.at("items_per_second");
    }
    void Finalize() override {
        fmt::print("\nns per reconstruction, one core\n{:<11}{:>14}{:>14}{:>16}{:>18}{:>20}{:>20}\n",
                   "technique", "along a curve", "over pixels", "scalar, robust", "scalar, textbook",
                   "textbook/curve", "textbook/pixels");
        for (const Technique& technique : techniques()) {
            const auto wide = nanoseconds_.find(technique.id);
            const auto pixels = nanoseconds_.find(fmt::format("{} pixels", technique.id));
            const auto robust = nanoseconds_.find(fmt::format("{} scalar", technique.id));
            const auto textbook = nanoseconds_.find(fmt::format("{} textbook", technique.id));
            if (wide == nanoseconds_.end() || robust == nanoseconds_.end() || pixels == nanoseconds_.end())
                continue;
            const bool has = textbook != nanoseconds_.end();
            const auto times = [&](double time) {
                return has ? fmt::format("{:.1f}", textbook->second / time) : "-";
            };
            fmt::print("{:<11}{:>14.1f}{:>14.1f}{:>16.1f}{:>18}{:>20}{:>20}\n", technique.id, wide->second,
                       pixels->second, robust->second, has ? fmt::format("{:.1f}", textbook->second) : "-",
                       times(wide->second), times(pixels->second));
        }
    }

private:
    std::map<std::string, double> nanoseconds_;
};

}  // namespace
}  // namespace momentscope

int main(int argc, char** argv) {
    using namespace momentscope;
    std::vector<Work> all;
    for (const Technique& technique : techniques())
        if (technique.has_moments()) all.push_back(work_for(technique));
    for (const Work& work : all)
        benchmark::RegisterBenchmark(work.technique->id,
                                     [work](benchmark::State& state) { run(state, {work}); });
    benchmark::RegisterBenchmark("all techniques", [all](benchmark::State& state) {
        run(state, all);
    })->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("every technique's curve, from fragments", run_everything)
        ->Unit(benchmark::kMicrosecond);
    for (const Technique& technique : techniques())
        if (technique.has_pixel_states() && has_function(technique))
            benchmark::RegisterBenchmark(technique.id, [&technique](benchmark::State& state) {
                run_pixel_state(state, technique);
            })->Unit(benchmark::kMicrosecond);
    for (const Work& work : all) {
        const std::string id = work.technique->id;
        benchmark::RegisterBenchmark((id + " pixels").c_str(),
                                     [work](benchmark::State& state) { run_pixels(state, work); });
        benchmark::RegisterBenchmark((id + " scalar").c_str(),
                                     [work](benchmark::State& state) { run_scalar(state, work, false); });
        if (work.technique->moment_kernel().has_textbook)
            benchmark::RegisterBenchmark((id + " textbook").c_str(),
                                         [work](benchmark::State& state) { run_scalar(state, work, true); });
    }
    benchmark::Initialize(&argc, argv);
    Table table;
    benchmark::RunSpecifiedBenchmarks(&table);
}
