#include "core/inspect/linear_program.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace momentscope {

LinearProgram::LinearProgram(std::span<const double> right_sides, double tolerance)
    : model_(Clp_newModel()), rows_(right_sides.size()) {
    std::iota(rows_.begin(), rows_.end(), 0);
    Clp_setLogLevel(model_.get(), 0);
    // Scaling magnifies the tolerance of small variables; then programs that have a solution seem to have
    // none.
    Clp_scaling(model_.get(), 0);
    Clp_resize(model_.get(), static_cast<int>(rows_.size()), 0);
    Clp_chgRowLower(model_.get(), right_sides.data());
    Clp_chgRowUpper(model_.get(), right_sides.data());
    Clp_setPrimalTolerance(model_.get(), tolerance);
    Clp_setDualTolerance(model_.get(), tolerance);
}

void LinearProgram::add_column(std::span<const double> column, double cost) {
    const double least = 0, most = std::numeric_limits<double>::max();
    const CoinBigIndex starts[] = {0, static_cast<CoinBigIndex>(column.size())};
    Clp_addColumns(model_.get(), 1, &least, &most, &cost, starts, rows_.data(), column.data());
}

void LinearProgram::set_costs(std::span<const double> costs) {
    Clp_chgObjCoefficients(model_.get(), costs.data());
}

bool LinearProgram::primal() {
    Clp_primal(model_.get(), 0);
    return Clp_isProvenOptimal(model_.get()) != 0;
}

bool LinearProgram::dual() {
    Clp_dual(model_.get(), 0);
    return Clp_isProvenOptimal(model_.get()) != 0;
}

void LinearProgram::forget_basis() {
    // The codes of ClpSimplex::Status. The status of the equations follows that of the variables.
    constexpr unsigned char BASIC = 1, AT_LOWER_BOUND = 3;
    std::vector<unsigned char> status(columns(), AT_LOWER_BOUND);
    status.resize(columns() + rows_.size(), BASIC);
    Clp_copyinStatus(model_.get(), status.data());
    std::fill_n(Clp_primalColumnSolution(model_.get()), columns(), 0.0);
}

}  // namespace momentscope
