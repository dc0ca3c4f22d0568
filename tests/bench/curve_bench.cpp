// curve_bench.cpp -- what the plot costs: curves of 512 depths with both bounds, from moments to absorbance.
#include <benchmark/benchmark.h>

#include <random>

#include "core/inspect/curve.hpp"

namespace momentscope {
namespace {

constexpr std::size_t SAMPLES = 512;

MomentVector five_fragments(const Technique& technique, const ResolvedParameters& parameters) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> depth(-1.0f, 1.0f);
    std::uniform_real_distribution<float> opacity(0.05f, 0.95f);
    ViewRay ray;
    for (int i = 0; i < 5; ++i) ray.fragments.push_back({.depth = depth(random), .opacity = opacity(random)});
    return sum_moments(ray, technique, parameters);
}

struct Work {
    const Technique* technique;
    ResolvedParameters parameters;
    MomentVector moments;
};

Work work_for(const Technique& technique) {
    const ResolvedParameters parameters = resolve({}, technique);
    return {&technique, parameters, five_fragments(technique, parameters)};
}

void evaluate(const Work& work, const std::vector<float>& depths, std::vector<float> (&curves)[3]) {
    work.technique->kernel->evaluate(work.moments, settings_of(work.parameters), depths,
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

}  // namespace
}  // namespace momentscope

int main(int argc, char** argv) {
    using namespace momentscope;
    std::vector<Work> all;
    for (const Technique& technique : techniques())
        if (technique.kernel != nullptr) all.push_back(work_for(technique));
    for (const Work& work : all)
        benchmark::RegisterBenchmark(work.technique->id,
                                     [work](benchmark::State& state) { run(state, {work}); });
    benchmark::RegisterBenchmark("all techniques", [all](benchmark::State& state) {
        run(state, all);
    })->Unit(benchmark::kMicrosecond);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
