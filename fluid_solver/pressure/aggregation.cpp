#include "fluid_solver/pressure/aggregation.hpp"

#include <algorithm>
#include <cassert>
#include <map>

#include "common/ordered_sum.hpp"

namespace cosurge::fluid {
namespace {

using Cell = std::array<int, 3>;

constexpr int reach = 2;  // cells to each side that a row can touch: r_e of the Laplacian over the cell size
constexpr int side = 2 * reach + 1;
constexpr int stencil = side * side * side;

int offset(const Cell& from, const Cell& to) {
  const int dx = to[0] - from[0] + reach;
  const int dy = to[1] - from[1] + reach;
  const int dz = to[2] - from[2] + reach;
  assert(dx >= 0 && dx < side && dy >= 0 && dy < side && dz >= 0 && dz < side);
  return (dz * side + dy) * side + dx;
}

/// One row of a coarse matrix while it is summed up: weights by relative cell, so that no search is needed.
struct RowSum {
  std::array<float, stencil> weight{};
  std::array<std::int32_t, stencil> column{};
  std::array<int, stencil> used{};
  int count = 0;

  void add(int at, std::int32_t to, float w) {
    if (weight[at] == 0) {
      used[count++] = at;
      column[at] = to;
    }
    weight[at] += w;
  }

  template <typename Level>
  void flush(Level& level) {
    std::sort(used.begin(), used.begin() + count);
    for (int k = 0; k < count; ++k) {
      level.column.push_back(column[used[k]]);
      level.weight.push_back(weight[used[k]]);
      weight[used[k]] = 0;
    }
    count = 0;
    level.begin.push_back(static_cast<std::int32_t>(level.column.size()));
  }
};

}  // namespace

void Aggregation::set_up(const Matrix& A, const CellsOfUnknowns& cells) {
  A_ = &A;
  const auto size = static_cast<std::size_t>(A.size());
  inverse_diagonal_.resize(size);
  for (std::size_t i = 0; i < size; ++i) inverse_diagonal_[i] = static_cast<float>(1.0 / A.diagonal[i]);
  for (auto* v : {&r_, &x_}) v->resize(size);
  first_ = cells.first;
  coarse_.clear();
  first_level(A, cells);
  while (coarse_.back().size() > directly) {
    Level next;
    next_level(coarse_.back(), next);
    const bool shrinks = next.size() < coarse_.back().size();
    coarse_.push_back(std::move(next));
    if (!shrinks) break;
  }
  factorise();
}

void Aggregation::first_level(const Matrix& A, const CellsOfUnknowns& cells) {
  Level level;
  level.cell = cells.cell;
  level.aggregate.resize(static_cast<std::size_t>(A.size()));
  const int aggregates = static_cast<int>(cells.cell.size());
  for (int a = 0; a < aggregates; ++a)
    for (int i = cells.first[a]; i < cells.first[a + 1]; ++i) level.aggregate[i] = a;
  level.begin = {0};
  RowSum row;
  for (int a = 0; a < aggregates; ++a) {
    double diagonal = 0;
    for (int i = cells.first[a]; i < cells.first[a + 1]; ++i) {
      diagonal += A.diagonal[i];
      A.each_run(i, [&](const Matrix::Run& run, const float* w) {
        const int end = run.first + run.length;
        int b = level.aggregate[run.first];
        for (int column = run.first; column < end; ++b) {
          const int stop = std::min(end, cells.first[b + 1]);
          float sum = 0;
          for (; column < stop; ++column) sum += w[column - run.first];
          if (b == a)
            diagonal -= static_cast<double>(sum);
          else if (sum != 0)
            row.add(offset(level.cell[a], level.cell[b]), b, sum);
        }
      });
    }
    level.diagonal.push_back(static_cast<float>(diagonal));
    row.flush(level);
  }
  coarse_.push_back(std::move(level));
}

void Aggregation::next_level(const Level& fine, Level& coarse) {
  std::map<Cell, std::int32_t> numbers;
  const auto parent = [](const Cell& cell) { return Cell{cell[0] >> 1, cell[1] >> 1, cell[2] >> 1}; };
  for (const Cell& cell : fine.cell) numbers.emplace(parent(cell), 0);
  for (auto& [cell, number] : numbers) {
    number = static_cast<std::int32_t>(coarse.cell.size());
    coarse.cell.push_back(cell);
  }
  std::vector<std::vector<std::int32_t>> members(coarse.cell.size());
  for (int i = 0; i < fine.size(); ++i) {
    coarse.aggregate.push_back(numbers.at(parent(fine.cell[i])));
    members[coarse.aggregate.back()].push_back(i);
  }
  coarse.begin = {0};
  RowSum row;
  for (int a = 0; a < static_cast<int>(members.size()); ++a) {
    float diagonal = 0;
    for (const std::int32_t i : members[a]) {
      diagonal += fine.diagonal[i];
      for (int k = fine.begin[i]; k < fine.begin[i + 1]; ++k) {
        const int b = coarse.aggregate[fine.column[k]];
        if (b == a)
          diagonal -= fine.weight[k];
        else
          row.add(offset(coarse.cell[a], coarse.cell[b]), b, fine.weight[k]);
      }
    }
    coarse.diagonal.push_back(diagonal);
    row.flush(coarse);
  }
}

void Aggregation::factorise() {
  for (Level& level : coarse_)
    for (auto* v : {&level.r, &level.x, &level.t}) v->resize(static_cast<std::size_t>(level.size()));
  const Level& last = coarse_.back();
  Eigen::MatrixXf dense = Eigen::MatrixXf::Zero(last.size(), last.size());
  for (int i = 0; i < last.size(); ++i) {
    // Rounding of the sums must not make a floating group of particles indefinite.
    dense(i, i) = last.diagonal[i] * (1 + 1e-5F);
    for (int k = last.begin[i]; k < last.begin[i + 1]; ++k) dense(i, last.column[k]) = -last.weight[k];
  }
  direct_.compute(dense);
}

/// Approximate solution of a coarse level: level.x from level.r.
void Aggregation::cycle(std::size_t depth) {
  Level& level = coarse_[depth];
  const int size = level.size();
  if (depth + 1 == coarse_.size()) {
    Eigen::Map<Eigen::VectorXf>(level.x.data(), size) =
        direct_.solve(Eigen::Map<Eigen::VectorXf>(level.r.data(), size));
    return;
  }
  const auto coupled = [&](int i, const std::vector<float>& x) {
    float sum = 0;
    for (int k = level.begin[i]; k < level.begin[i + 1]; ++k) sum += level.weight[k] * x[level.column[k]];
    return sum;
  };
  for (int i = 0; i < size; ++i) level.x[i] = damping * level.r[i] / level.diagonal[i];
  Level& next = coarse_[depth + 1];
  std::fill(next.r.begin(), next.r.end(), 0.0F);
  for (int i = 0; i < size; ++i)
    next.r[next.aggregate[i]] += level.r[i] - level.diagonal[i] * level.x[i] + coupled(i, level.x);
  cycle(depth + 1);
  for (int i = 0; i < size; ++i) level.x[i] += correction * next.x[next.aggregate[i]];
  for (int i = 0; i < size; ++i)
    level.t[i] = level.x[i] + damping * ((level.r[i] + coupled(i, level.x)) / level.diagonal[i] - level.x[i]);
  level.x.swap(level.t);
}

void Aggregation::apply(const std::vector<double>& r, std::vector<double>& z) {
  const int size = A_->size();
  Level& next = coarse_.front();
#pragma omp parallel for simd schedule(static) if (size >= parallel_from)
  for (int i = 0; i < size; ++i) {
    r_[i] = static_cast<float>(r[i]);
    x_[i] = damping * inverse_diagonal_[i] * r_[i];
  }
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (int a = 0; a < next.size(); ++a) {
    float sum = 0;
    for (int i = first_[a]; i < first_[a + 1]; ++i)
      sum += (1 - damping) * r_[i] + A_->off_diagonal(i, x_.data());  // the residual after the sweep
    next.r[a] = sum;
  }
  cycle(0);
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (int i = 0; i < size; ++i) x_[i] += correction * next.x[next.aggregate[i]];
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (int i = 0; i < size; ++i)
    z[i] = x_[i] + damping * (inverse_diagonal_[i] * (r_[i] + A_->off_diagonal(i, x_.data())) - x_[i]);
}

}  // namespace cosurge::fluid
