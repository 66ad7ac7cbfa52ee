// Building by the surface area heuristic, evaluated at bins of the centroids [Wald07].
#include <algorithm>
#include <array>

#include "renderer/accel/bvh_tree.h"
#include "renderer/base/parallel.h"

namespace candela::bvh {
namespace {

constexpr int bin_count = 16;
constexpr int heuristic_levels = 32;  // below, ranges are halved
constexpr std::size_t parallel_items = 4096;
constexpr float no_cost = std::numeric_limits<float>::infinity();

struct Item {
  Bounds3f box;
  std::uint32_t index;
};

struct Range {
  std::size_t first, count;
  Bounds3f box, centroids;
};

struct Bin {
  Bounds3f box;
  std::size_t count = 0;
  void include(const Bin& other) {
    box.include(other.box);
    count += other.count;
  }
};

struct Binning {
  Vec3f lower, scale;

  explicit Binning(const Bounds3f& centroids) : lower(centroids.lower) {
    const Vec3f extent = centroids.extent();
    for (int axis = 0; axis < 3; ++axis)
      scale[axis] = extent[axis] > 0 ? std::min(bin_count / extent[axis], 0x1p127f) : 0.0f;
  }
  [[nodiscard]] int bin_of(const Bounds3f& box, int axis) const {
    const float place = (box.centre()[axis] - lower[axis]) * scale[axis];
    return static_cast<int>(std::min(place, float{bin_count - 1}));
  }
};

struct Split {
  float cost = no_cost;
  int axis = 0;
  int first_right_bin = 0;
};

// Moves a subtree that was built on its own to the end of the tree; returns its root's new name.
Child append(const Tree& part, Tree& tree) {
  const auto moved = [nodes = tree.nodes.size(), leaves = tree.leaves.size()](Child child) {
    if (child == no_child) return child;
    return child + static_cast<Child>(child & leaf_bit ? leaves : nodes);
  };
  tree.leaves.insert(tree.leaves.end(), part.leaves.begin(), part.leaves.end());
  for (Node node : part.nodes) {
    for (Child& child : node.children) child = moved(child);
    tree.nodes.push_back(node);
  }
  return moved(part.root);
}

struct Builder {
  std::vector<Item> items;
  std::size_t leaf_size;

  [[nodiscard]] Range range_of(std::size_t first, std::size_t count) const {
    Range range{first, count, {}, {}};
    for (std::size_t i = first; i < first + count; ++i) {
      range.box.include(items[i].box);
      range.centroids.include(items[i].box.centre());
    }
    return range;
  }

  // Area times the leaves needed: testing a leaf costs the same for any number of items in it. The
  // heuristic's other constants drop out, since all that does not fit into a leaf is split.
  [[nodiscard]] float cost_of(const Bin& side) const {
    const std::size_t leaves = (side.count + leaf_size - 1) / leaf_size;
    return side.count > 0 ? side.box.surface_area() * static_cast<float>(leaves) : no_cost;
  }

  [[nodiscard]] Split best_split(const Range& range, const Binning& binning, int axis) const {
    std::array<Bin, bin_count> bins;
    for (std::size_t i = range.first; i < range.first + range.count; ++i)
      bins[static_cast<std::size_t>(binning.bin_of(items[i].box, axis))].include({items[i].box, 1});
    std::array<float, bin_count> right_cost{};
    Bin right, left;
    for (std::size_t i = bin_count - 1; i > 0; --i) {
      right.include(bins[i]);
      right_cost[i] = cost_of(right);
    }
    Split best;
    for (std::size_t i = 1; i < bin_count; ++i) {
      left.include(bins[i - 1]);
      const float cost = cost_of(left) + right_cost[i];
      if (cost < best.cost) best = {cost, axis, static_cast<int>(i)};
    }
    return best;
  }

  // Returns how many items went to the left: at least one, and not all. Items whose centroids all
  // fall into one bin are halved as they come.
  [[nodiscard]] std::size_t partition(const Range& range, int level) {
    const Binning binning(range.centroids);
    Split split;
    for (int axis = 0; axis < 3 && level < heuristic_levels; ++axis) {
      const Split candidate = best_split(range, binning, axis);
      if (candidate.cost < split.cost) split = candidate;
    }
    if (!(split.cost < no_cost)) return range.count / 2;
    const auto begin = items.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto end = begin + static_cast<std::ptrdiff_t>(range.count);
    const auto middle = std::partition(begin, end, [&](const Item& item) {
      return binning.bin_of(item.box, split.axis) < split.first_right_bin;
    });
    return static_cast<std::size_t>(middle - begin);
  }

  // Splits the range in two, then its part of the largest area, until there are four.
  [[nodiscard]] std::vector<Range> split_in_four(const Range& range, int level) {
    std::vector<Range> parts{range};
    const auto area = [&](const Range& part) {
      return part.count <= leaf_size ? -1.0f : part.box.surface_area();
    };
    const auto is_smaller = [&](const Range& a, const Range& b) { return area(a) < area(b); };
    while (parts.size() < 4) {
      const auto largest = std::max_element(parts.begin(), parts.end(), is_smaller);
      if (largest->count <= leaf_size) break;
      const Range whole = *largest;
      const std::size_t left = partition(whole, level);
      *largest = range_of(whole.first, left);
      parts.insert(largest + 1, range_of(whole.first + left, whole.count - left));
    }
    return parts;
  }

  // Appends the range's subtree to the tree and returns its root.
  Child build(const Range& range, int level, Tree& tree) {
    if (range.count <= leaf_size) {
      Leaf leaf;
      for (std::size_t i = 0; i < range.count; ++i)
        leaf.items[leaf.count++] = items[range.first + i].index;
      tree.leaves.push_back(leaf);
      return leaf_bit | static_cast<Child>(tree.leaves.size() - 1);
    }
    const std::vector<Range> parts = split_in_four(range, level);
    const std::size_t place = tree.nodes.size();
    tree.nodes.emplace_back();
    std::array<Tree, 4> subtrees;
    const auto build_apart = [&](std::size_t i) {
      subtrees[i].root = build(parts[i], level + 1, subtrees[i]);
    };
    const bool is_parallel = range.count >= parallel_items;
    if (is_parallel) parallel_for(parts.size(), build_apart);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Child child =
          is_parallel ? append(subtrees[i], tree) : build(parts[i], level + 1, tree);
      tree.nodes[place].set_child(i, parts[i].box, child);
    }
    return static_cast<Child>(place);
  }
};

}  // namespace

Tree build_tree(const std::vector<Bounds3f>& boxes, std::uint32_t leaf_size) {
  Tree tree;
  Builder builder{{}, leaf_size};
  for (std::size_t i = 0; i < boxes.size(); ++i)
    builder.items.push_back({boxes[i], static_cast<std::uint32_t>(i)});
  const Range all = builder.range_of(0, boxes.size());
  tree.bounds = all.box;
  if (all.count > 0) tree.root = builder.build(all, 0, tree);
  return tree;
}

}  // namespace candela::bvh
