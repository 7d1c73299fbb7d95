// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <algorithm>
#include <limits>
#include <vector>

#include "base/types.h"

namespace hexfeature {

/// A tree of boxes over numbered items, for the nearest one to a point. Flat, deterministic, read-only once built.
class BoxTree {
 public:
  struct Box {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = Vec3::Constant(-std::numeric_limits<double>::max());
    void add(const Vec3& p) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    double distance2(const Vec3& p) const { return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm(); }
  };

  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes) {
    order_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) order_[i] = static_cast<int>(i);
    if (!boxes.empty()) build(boxes, 0, static_cast<int>(boxes.size()));
  }

  /// Calls distance2(item) for items that may be closer than the best so far, which it starts with `bound`;
  /// returns the nearest item, or -1 when none is closer than the bound.
  template <class Distance2>
  int nearest(const Vec3& p, double bound, Distance2&& distance2) const {
    int best = -1;
    if (nodes_.empty()) return best;
    int stack[64], top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      if (node.box.distance2(p) >= bound) continue;
      if (node.right == 0) {
        for (int i = node.begin; i < node.end; ++i) {
          const double d = distance2(order_[i]);
          if (d < bound) {
            bound = d;
            best = order_[i];
          }
        }
        continue;
      }
      const int left = static_cast<int>(&node - nodes_.data()) + 1;
      const bool left_first = nodes_[left].box.distance2(p) <= nodes_[node.right].box.distance2(p);
      stack[top++] = left_first ? node.right : left;
      stack[top++] = left_first ? left : node.right;
    }
    return best;
  }

 private:
  struct Node {
    Box box;
    int begin = 0, end = 0, right = 0;  // the left child follows its parent; right 0: a leaf
  };
  int build(const std::vector<Box>& boxes, int begin, int end) {
    const int self = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    Box box, centres;
    for (int i = begin; i < end; ++i) {
      const Box& b = boxes[order_[i]];
      box.add(b.low);
      box.add(b.high);
      centres.add(0.5 * (b.low + b.high));
    }
    nodes_[self].box = box;
    nodes_[self].begin = begin;
    nodes_[self].end = end;
    if (end - begin <= 4) return self;
    int axis;
    (centres.high - centres.low).maxCoeff(&axis);
    const int middle = (begin + end) / 2;  // halves by count: depth at most 32
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
      const double ca = boxes[a].low[axis] + boxes[a].high[axis], cb = boxes[b].low[axis] + boxes[b].high[axis];
      return ca != cb ? ca < cb : a < b;
    });
    build(boxes, begin, middle);
    const int right = build(boxes, middle, end);
    nodes_[self].right = right;
    return self;
  }
  std::vector<Node> nodes_;
  std::vector<int> order_;
};

}  // namespace hexfeature
