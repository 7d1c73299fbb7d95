// HexFeatureWB - LGPL-2.1-or-later
#include "fit/quad_net.h"

namespace hexfeature {

QuadNet make_quad_net(const std::vector<std::array<int, 4>>& quads, int node_count) {
  QuadNet net;
  net.quads = quads;
  const int halfedges = 4 * static_cast<int>(quads.size());
  net.out_begin.assign(node_count + 1, 0);
  for (int g = 0; g < halfedges; ++g) ++net.out_begin[net.from(g) + 1];
  for (int n = 0; n < node_count; ++n) net.out_begin[n + 1] += net.out_begin[n];
  net.out.resize(halfedges);
  std::vector<int> fill(net.out_begin.begin(), net.out_begin.end() - 1);
  for (int g = 0; g < halfedges; ++g) net.out[fill[net.from(g)]++] = g;
  net.opposite.resize(halfedges);
  for (int g = 0; g < halfedges; ++g) net.opposite[g] = net.find(net.to(g), net.from(g));
  return net;
}

}  // namespace hexfeature
