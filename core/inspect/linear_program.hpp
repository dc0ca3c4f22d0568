// linear_program.hpp -- a linear program with equations and variables that are not negative. CLP solves it.
#pragma once
#include <Clp_C_Interface.h>

#include <memory>
#include <span>
#include <vector>

namespace momentscope {

/// Finds x >= 0 with A x = b and the least cost. It calls CLP through its C interface, because the classes of
/// CLP hold strings of one standard library and cannot be used with another.
class LinearProgram {
public:
    /// b, and the tolerance of the equations and of reduced costs. There are no variables yet.
    LinearProgram(std::span<const double> right_sides, double tolerance);

    void set_max_pivots(int count) { Clp_setMaximumIterations(model_.get(), count); }

    /// Adds a variable: its column of A and its cost.
    void add_column(std::span<const double> column, double cost);

    /// Replaces the costs of all variables.
    void set_costs(std::span<const double> costs);

    /// The primal and the dual simplex algorithm. They start where the last one ended. False if no optimum is
    /// found.
    bool primal();
    bool dual();

    /// Makes the next algorithm start without a basis.
    void forget_basis();

    /// The solution: its cost, the variables, and the dual variables, one for each equation.
    double cost() const { return Clp_objectiveValue(model_.get()); }
    std::span<const double> variables() const { return {Clp_primalColumnSolution(model_.get()), columns()}; }
    std::span<const double> duals() const { return {Clp_dualRowSolution(model_.get()), rows_.size()}; }

private:
    std::size_t columns() const { return static_cast<std::size_t>(Clp_numberColumns(model_.get())); }

    struct Delete {
        void operator()(Clp_Simplex* model) const { Clp_deleteModel(model); }
    };
    std::unique_ptr<Clp_Simplex, Delete> model_;
    std::vector<int> rows_;  // 0, 1, ...: columns are given in full
};

}  // namespace momentscope
