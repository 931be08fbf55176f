#include "wear/evolve/surface_loss.h"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "mill/base/failure.h"
#include "wear/surface/along_profile.h"
#include "wear/surface/closing.h"

namespace millwear::wear {
namespace {

/// The nodes of a pitch, those at one place as one, and the ways between them.
struct Chain {
  std::vector<Eigen::Index> of_node;  ///< place of every node
  Eigen::VectorXd to_next;            ///< [m], of every place; the last leads to the next pitch
  Eigen::VectorXd rates;              ///< mean of the nodes at the place
  Eigen::VectorXd turns;

  [[nodiscard]] Eigen::Index size() const { return to_next.size(); }
  [[nodiscard]] Eigen::Index before(Eigen::Index i) const { return (i + size() - 1) % size(); }
  [[nodiscard]] double length(Eigen::Index i) const {
    return 0.5 * (to_next[before(i)] + to_next[i]);
  }
  /// Way of the ball's centre about a place.
  [[nodiscard]] double way(Eigen::Index i, double radius) const {
    return std::max(0.0, length(i) + radius * turns[i]);
  }
};

Chain chain_of(const SurfaceLoss& loss) {
  const auto& nodes = loss.nodes;
  Chain chain;
  std::vector<double> to_next;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const bool is_same = i > 0 && nodes[i].position == nodes[i - 1].position;
    if (!is_same) {
      first.push_back(i);
      to_next.push_back(0.0);
    }
    chain.of_node.push_back(static_cast<Eigen::Index>(first.size()) - 1);
    to_next.back() = (nodes[i + 1].position - nodes[i].position).norm();
  }
  chain.of_node.push_back(0);
  chain.to_next =
      Eigen::Map<const Eigen::VectorXd>(to_next.data(), static_cast<Eigen::Index>(to_next.size()));
  chain.rates = Eigen::VectorXd::Zero(chain.size());
  chain.turns = Eigen::VectorXd::Zero(chain.size());
  Eigen::VectorXd count = Eigen::VectorXd::Zero(chain.size());
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Eigen::Index place = chain.of_node[i];
    chain.rates[place] += nodes[i].depth;
    chain.turns[place] += loss.turns[static_cast<Eigen::Index>(i)];
    count[place] += 1.0;
  }
  chain.rates = chain.rates.cwiseQuotient(count);
  return chain;
}

/// Of every node; of two at one place the first has the whole.
Eigen::VectorXd turns_of(const LinerSector& sector, const std::vector<LossNode>& nodes) {
  Eigen::VectorXd turns = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nodes.size()));
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  for (std::size_t i = nodes.size() - 1; i > 0 && last.norm() == 0.0; --i)
    last = nodes.front().position - shifted_by_pitches(sector, nodes[i - 1].position, -1);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Eigen::Vector2d along = nodes[i + 1].position - nodes[i].position;
    if (along.norm() == 0.0) continue;
    turns[static_cast<Eigen::Index>(i)] = -turn_between(last, along);
    last = along;
  }
  return turns;
}

/// Leaves the turns under the arcs of the closing out.
void forget_turns(const std::vector<Arc>& arcs, const std::vector<LossNode>& nodes,
                  Eigen::VectorXd& turns) {
  double arc_length = 0.0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i > 0) arc_length += (nodes[i].position - nodes[i - 1].position).norm();
    for (const Arc& arc : arcs)
      if (arc_length >= arc.from - same_point && arc_length <= arc.to + same_point)
        turns[static_cast<Eigen::Index>(i)] = 0.0;
  }
}

}  // namespace

SurfaceLoss surface_loss(const LinerProfile& liner, const LoadInTime& load, double time) {
  const auto& balls = load.balls();
  const Closing closing =
      balls.smallest > 0.0 ? closing_of(liner, balls.smallest) : Closing{liner, {}, {}};
  const Eigen::VectorXd at_nodes = load.carrier().onto_nodes(closing.surface) * load.per_path(time);
  Eigen::Index node = 0;
  SurfaceLoss loss{loss_nodes(closing.surface, load.carrier().bin_width(),
                              [&](double) { return at_nodes[node++]; }),
                   {},
                   balls.mean,
                   load.corrosion()};
  loss.turns = turns_of(liner.sector, loss.nodes);
  forget_turns(closing.arcs, loss.nodes, loss.turns);
  return loss;
}

double section_rate(const SurfaceLoss& loss) {
  if (loss.ball_radius == 0.0) return loss_area(depths_after(loss, 1.0));
  const Chain chain = chain_of(loss);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < chain.size(); ++i)
    sum += chain.rates[i] * chain.way(i, loss.ball_radius) + loss.corrosion * chain.length(i);
  return sum;
}

std::vector<LossNode> depths_after(const SurfaceLoss& loss, double duration) {
  std::vector<LossNode> nodes = loss.nodes;
  if (loss.ball_radius == 0.0) {
    for (LossNode& node : nodes) node.depth = duration * (node.depth + loss.corrosion);
    return nodes;
  }
  const Chain chain = chain_of(loss);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right(chain.size());
  for (Eigen::Index i = 0; i < chain.size(); ++i) {
    const double spread = duration * chain.rates[i] * loss.ball_radius;
    const double back = spread / chain.to_next[chain.before(i)];
    const double on = spread / chain.to_next[i];
    entries.emplace_back(i, i, chain.length(i) + back + on);
    entries.emplace_back(i, chain.before(i), -back);
    entries.emplace_back(i, (i + 1) % chain.size(), -on);
    right[i] = duration *
               (chain.rates[i] * chain.way(i, loss.ball_radius) + loss.corrosion * chain.length(i));
  }
  Eigen::SparseMatrix<double> matrix(chain.size(), chain.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success)
    throw ResultRejected("the depths that the load wears cannot be solved for");
  const Eigen::VectorXd depths = solver.solve(right);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    nodes[i].depth = std::max(0.0, depths[chain.of_node[i]]);
  return nodes;
}

}  // namespace millwear::wear
