// HexFeatureWB - LGPL-2.1-or-later
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstdint>

#include "fit/fit.h"

namespace hexfeature {

void fit_interior(HexComplex& complex, Context& context) {
  const int n = complex.point_count();
  std::vector<int> variable(n, -1);
  int variables = 0;
  for (int i = 0; i < n; ++i)
    if (complex.place[i].dim == 3) variable[i] = variables++;
  if (variables == 0) return;

  std::vector<std::uint64_t> edges;
  edges.reserve(12 * complex.hexes.size());
  for (const auto& hex : complex.hexes)
    for (const auto& e : kHexEdges) {
      const auto a = static_cast<std::uint64_t>(std::min(hex[e[0]], hex[e[1]])),
                 b = static_cast<std::uint64_t>(std::max(hex[e[0]], hex[e[1]]));
      edges.push_back(a << 32 | b);
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  using Matrix = Eigen::SparseMatrix<double>;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * edges.size());
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(variables, 3);
  std::vector<double> diagonal(variables, 0);
  for (const std::uint64_t key : edges) {
    const int a = static_cast<int>(key >> 32), b = static_cast<int>(key & 0xffffffffu);
    const int i = variable[a], j = variable[b];
    if (i >= 0) diagonal[i] += 1;
    if (j >= 0) diagonal[j] += 1;
    if (i >= 0 && j >= 0) entries.emplace_back(std::max(i, j), std::min(i, j), -1.0);
    if (i >= 0 && j < 0) right.row(i) += complex.points[b].transpose();
    if (j >= 0 && i < 0) right.row(j) += complex.points[a].transpose();
  }
  for (int i = 0; i < variables; ++i) entries.emplace_back(i, i, diagonal[i]);
  Matrix matrix(variables, variables);
  matrix.setFromTriplets(entries.begin(), entries.end());
  context.check();

  // Incomplete Cholesky: the matrix is an M-matrix. Natural order keeps neighbours of the lattice near each other.
  Eigen::ConjugateGradient<Matrix, Eigen::Lower, Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>> solver;
  solver.compute(matrix);
  solver.setTolerance(1e-5);
  solver.setMaxIterations(400);
  for (int axis = 0; axis < 3; ++axis) {
    context.check();
    const Eigen::VectorXd x = solver.solve(right.col(axis));
    for (int i = 0; i < n; ++i)
      if (variable[i] >= 0) complex.points[i][axis] = x[variable[i]];
  }
}

}  // namespace hexfeature
