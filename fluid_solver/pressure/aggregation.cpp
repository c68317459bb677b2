#include "fluid_solver/pressure/aggregation.hpp"

#include <algorithm>

#include "common/ordered_sum.hpp"

namespace cosurge::fluid {
namespace {

using Cell = std::array<int, 3>;

constexpr int widest = 125;  // aggregates that the rows of one can touch: those within two cells

/// Number of the group of 2 x 2 (x 2) cells that each cell belongs to, in the order of the groups' first
/// cells.
std::vector<std::int32_t> pair_up(const std::vector<Cell>& cells, std::vector<Cell>& groups) {
  Cell size{};
  for (const Cell& cell : cells)
    for (int k = 0; k < 3; ++k) size[k] = std::max(size[k], (cell[k] >> 1) + 1);
  std::vector<std::int32_t> number(static_cast<std::size_t>(size[0]) * size[1] * size[2], -1);
  std::vector<std::int32_t> group;
  for (const Cell& cell : cells) {
    const Cell parent{cell[0] >> 1, cell[1] >> 1, cell[2] >> 1};
    std::int32_t& own =
        number[(static_cast<std::size_t>(parent[2]) * size[1] + parent[1]) * size[0] + parent[0]];
    if (own < 0) {
      own = static_cast<std::int32_t>(groups.size());
      groups.push_back(parent);
    }
    group.push_back(own);
  }
  return group;
}

}  // namespace

void Aggregation::Level::list_members() {
  begin.assign(cell.size() + 1, 0);
  for (const std::int32_t a : aggregate) ++begin[static_cast<std::size_t>(a) + 1];
  for (std::size_t a = 0; a < cell.size(); ++a) begin[a + 1] += begin[a];
  std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
  member.resize(aggregate.size());
  for (std::size_t i = 0; i < aggregate.size(); ++i)
    member[next[aggregate[i]]++] = static_cast<std::int32_t>(i);
}

void Aggregation::set_up(const Matrix& A, const CellsOfUnknowns& cells) {
  A_ = &A;
  first_ = cells.first;
  coarse_.clear();
  coarse_.push_back(first_level(A, cells));
  while (coarse_.back().size() > directly) {
    Level next = next_level(coarse_.back());
    const bool shrinks = next.size() < coarse_.back().size();
    coarse_.push_back(std::move(next));
    if (!shrinks) break;
  }
  factorise();
}

/// Sums the rows of each cell column by column, and then the columns of each cell around it.
auto Aggregation::first_level(const Matrix& A, const CellsOfUnknowns& cells) const -> Level {
  Level level;
  level.cell = cells.cell;
  level.diagonal.resize(cells.cell.size());
  const auto fill = [&](int a, std::int64_t begin) {
    thread_local std::vector<float> sums;
    sums.resize(Matrix::padded(A.size()), 0.0F);
    double diagonal = 0;
    for (int i = first_[a]; i < first_[a + 1]; ++i) {
      diagonal += A.diagonal[i];
      for (std::int64_t b = A.rows.begin(i); b < A.rows.end(i); ++b) {
        float* const columns = sums.data() + A.first[b];
        const float* const w = A.weight.data() + b * Matrix::lanes;
        for (int k = 0; k < Matrix::lanes; ++k) columns[k] += w[k];
      }
    }
    std::int64_t end = begin;
    for (int l = 0; l < cells.lines_per_cell; ++l) {
      const auto line = cells.line[static_cast<std::size_t>(a) * cells.lines_per_cell + l];
      for (std::int32_t b = line.begin; b < line.end; ++b) {
        float sum = 0;
        for (int column = first_[b]; column < first_[b + 1]; ++column) {
          sum += sums[column];
          sums[column] = 0;
        }
        if (b == a) {
          diagonal -= static_cast<double>(sum);
        } else if (sum != 0) {
          level.append(b, sum, level.size(), begin, end);
        }
      }
    }
    level.diagonal[a] = static_cast<float>(diagonal);
    return end - begin;
  };
  const auto room = [&](std::int64_t blocks) { level.make_room(blocks); };
  level.rows.fill(cells.size(), cells.lines_per_cell, cells.lines_per_cell, room, fill);
  return level;
}

auto Aggregation::next_level(const Level& fine) -> Level {
  Level level;
  level.aggregate = pair_up(fine.cell, level.cell);
  level.list_members();
  level.diagonal.resize(level.cell.size());
  const auto fill = [&](int a, std::int64_t begin) {
    thread_local std::vector<float> sums;
    thread_local std::vector<std::int32_t> columns;
    sums.resize(level.cell.size(), 0.0F);
    columns.clear();
    float diagonal = 0;
    for (int m = level.begin[a]; m < level.begin[a + 1]; ++m) {
      diagonal += fine.diagonal[level.member[m]];
      fine.each(level.member[m], [&](int column, float w) {
        const std::int32_t b = level.aggregate[column];
        if (sums[b] == 0) columns.push_back(b);
        sums[b] += w;
      });
    }
    std::sort(columns.begin(), columns.end());
    std::int64_t end = begin;
    for (const std::int32_t b : columns) {
      if (b == a)
        diagonal -= sums[b];
      else
        level.append(b, sums[b], level.size(), begin, end);
      sums[b] = 0;
    }
    level.diagonal[a] = diagonal;
    return end - begin;
  };
  const auto room = [&](std::int64_t blocks) { level.make_room(blocks); };
  level.rows.fill(level.size(), widest / 8, widest, room, fill);
  return level;
}

void Aggregation::factorise() {
  for (Level& level : coarse_)
    for (auto* v : {&level.r, &level.x, &level.t}) v->resize(Matrix::padded(level.size()));
  const Level& last = coarse_.back();
  Eigen::MatrixXf dense = Eigen::MatrixXf::Zero(last.size(), last.size());
  for (int i = 0; i < last.size(); ++i) {
    // Rounding of the sums must not make a floating group of particles indefinite.
    dense(i, i) = last.diagonal[i] * (1 + 1e-5F);
    last.each(i, [&](int j, float w) { dense(i, j) = -w; });
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
  Level& next = coarse_[depth + 1];
  float* const x = level.x.data();
#pragma omp parallel for simd schedule(static) if (size >= parallel_from)
  for (int i = 0; i < size; ++i) x[i] = damping * level.r[i] / level.diagonal[i];
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (int a = 0; a < next.size(); ++a) {
    float sum = 0;  // sum of residuals
    for (int m = next.begin[a]; m < next.begin[a + 1]; ++m)
      sum += (1 - damping) * level.r[next.member[m]] + level.product(next.member[m], x);
    next.r[a] = sum;
  }
  cycle(depth + 1);
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (int i = 0; i < size; ++i) x[i] += correction * next.x[next.aggregate[i]];
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (int i = 0; i < size; ++i)
    level.t[i] = x[i] + damping * ((level.r[i] + level.product(i, x)) / level.diagonal[i] - x[i]);
  level.x.swap(level.t);
}

void Aggregation::apply(const std::vector<double>& r, std::vector<float>& z) {
  const int size = A_->size();
  Level& coarse = coarse_.front();
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (int a = 0; a < coarse.size(); ++a) {
    double sum = 0;
    for (int i = first_[a]; i < first_[a + 1]; ++i) sum += r[i];
    coarse.r[a] = static_cast<float>(sum);
  }
  cycle(0);
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (int a = 0; a < coarse.size(); ++a) {
    const float x = correction * coarse.x[a];
    for (int i = first_[a]; i < first_[a + 1]; ++i) z[i] = static_cast<float>(r[i] / A_->diagonal[i]) + x;
  }
}

}  // namespace cosurge::fluid
