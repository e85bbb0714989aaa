#ifndef TETRACONE_TETRATREE_PAPER_CONFIG_H
#define TETRACONE_TETRATREE_PAPER_CONFIG_H

#include <cstddef>
#include <limits>

namespace tetracone::tetratree {

/// How the far plane of a bounding tetrahedron is found (JS08 section 2.3.1).
enum class Far_plane {
  shortened,  ///< the paper's loop: from an isosceles tetrahedron, edges are shortened one at a time while it still
              ///< bounds
  tightest    ///< the plane of least volume, by a search over its two directions
};

/// How the centre of a bounding sphere is found (JS08 section 2.3.2). The radius is always the distance of the farthest
/// vertex.
enum class Sphere_centre {
  centroid,  ///< the paper's: the mean of the vertices
  improved   ///< close to the centre of the smallest enclosing ball
};

/// Which of two nodes that may touch is descended.
enum class Descent {
  larger_first,  ///< the one of larger volume, as section 3 advises
  both           ///< both at once, as the listing in the appendix does
};

/// The choices for a tetra-tree and its queries. The default is the method as the paper lists it.
struct Config {
  /// The deepest level of tetra-cones; octants are level 1. 0 makes the tree one list without cones. The default is the
  /// level at which a cone holds about one triangle of a star-shaped object ("adjusted to the number of vertices").
  static constexpr int by_size = -1;
  int depth = by_size;

  /// A cone with at most this many tetrahedra is a leaf.
  std::size_t leaf_size = 8;

  /// True: nodes are made when a query first enters their parent, instead of all at the start.
  bool on_demand = false;

  Far_plane far_plane = Far_plane::shortened;
  /// The loop of `Far_plane::shortened`: rounds over the three edges, and the fraction by which an edge is shortened.
  /// The last is the fraction by which it is lengthened again when that was too much. Departure: JS08 Fig. 8 has 10 %
  /// and 5 %, and gives no number of rounds. `experiments/speed/paper_experiment.cpp` measures what other fractions
  /// cost and save, and what no round does.
  int shortening_rounds = 60;
  double shorten_by = 0.03, lengthen_by = 0.015;

  Sphere_centre sphere_centre = Sphere_centre::centroid;

  /// Theorem 2: a bounding tetrahedron that lies beyond the plane of the other body's reference bounding tetrahedron is
  /// discarded.
  bool regular_hull = true;

  /// Pairs of nodes are discarded by their bounding spheres, and by their bounding tetrahedra.
  bool spheres = true;
  bool tetrahedra = true;

  /// Pairs of nodes are discarded by oriented boxes about the vertices of what is classified in them. Not in the paper.
  bool boxes = false;

  Descent descent = Descent::larger_first;

  /// Bounding tetrahedra are compared along all 44 axes, which is the complete test of two tetrahedra, or along their 8
  /// face normals only.
  bool all_axes = true;

  /// In leaves, edges and faces whose axis-aligned boxes are apart are not tested further. Not in the paper.
  bool leaf_boxes = false;

  /// The fraction of all pairs of an edge and a face whose time a descent may take. Beyond it the query tests each pair
  /// once instead. An element in many cones is listed in each, and tested in every pair of their leaves. In exact
  /// kernels pairs of nodes count too, since bodies of a few faces have nearly as many of them. So do the edges of a
  /// face whose plane an edge crosses. Infinite means never, as the paper lists it.
  double all_pairs_after = std::numeric_limits<double>::infinity();

  /// Returns the paper's method, never far slower than no tree at all.
  static Config paper()
  {
    Config config;
    config.all_pairs_after = 1.0 / 32;
    return config;
  }

  /// Returns the fastest choices known for the paper's structure. They drop the hull. The far plane,
  /// sphere's centre, leaf boxes and `all_pairs_after` are not the paper's.
  static Config fastest()
  {
    Config config;
    config.all_pairs_after = 0.25;  // pairs whose boxes are apart cost little
    config.far_plane = Far_plane::tightest;
    config.sphere_centre = Sphere_centre::improved;
    config.regular_hull = false;
    config.leaf_boxes = true;
    return config;
  }

  /// Returns the choice of no tree: every edge is tested against every face.
  static Config brute()
  {
    Config config;
    config.depth = 0;
    return config;
  }
};

}  // namespace tetracone::tetratree

#endif
