#include "verify/families/scene_families.h"

#include "verify/cases/exact_map.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/shape_generators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tetracone::verify {
namespace scene_family {
namespace {

using namespace object_family;

constexpr int frame_count = 8;

/// A scene during its making: the present bodies, and the frames so far.
class Play {
 public:
  explicit Play(Random& random) : random_(random) {}

  std::size_t add_model(const Body& body)
  {
    made_.models.push_back(body);
    return made_.models.size() - 1;
  }
  /// Adds `count` models of any kind.
  void add_models(int count, const Shape& (*any)(Random&) = any_block)
  {
    for (int k = 0; k < count; ++k) add_model(any(random_).body);
  }
  std::size_t any_model() { return one_below(made_.models.size()); }

  /// Adds a body of a model, which exists from now on. Returns its number.
  std::size_t add_body(std::size_t model, const Pose& pose)
  {
    now_.bodies.push_back(Scene_case::Standing{model, pose});
    return now_.bodies.size() - 1;
  }

  std::size_t body_count() const { return now_.bodies.size(); }
  std::optional<Scene_case::Standing>& body(std::size_t k) { return now_.bodies[k]; }
  void place(std::size_t k, const Pose& pose) { now_.bodies[k]->pose = pose; }
  void ignore(std::size_t a, std::size_t b) { now_.ignored.push_back({std::min(a, b), std::max(a, b)}); }

  std::size_t one_below(std::size_t count) { return random_.bits() % count; }
  bool one_in(std::size_t count) { return one_below(count) == 0; }

  /// Calls change(frame number) before each frame except the first.
  template <class Change>
  Scene_case frames(const Change& change)
  {
    for (int frame = 0; frame < frame_count; ++frame) {
      if (frame > 0) change(frame);
      made_.frames.push_back(now_);
    }
    for (Scene_case::Frame& frame : made_.frames) frame.bodies.resize(now_.bodies.size());
    return made_;
  }

 private:
  Random& random_;
  Scene_case made_{};
  Scene_case::Frame now_;
};

// --- rigid motions, rounded ------------------------------------------------------------------------------------------

struct Rigid {
  std::array<double, 4> turn;
  Vector at;

  Pose pose() const { return rotated(rotation(turn[0], turn[1], turn[2], turn[3]), at); }
};

Rigid anywhere(Random& random, double size)
{
  Rigid rigid{random.quaternion(), {}};
  for (double& x : rigid.at) x = size * random.symmetric();
  return rigid;
}

void drift(Random& random, Rigid& rigid, double by)
{
  for (double& x : rigid.at) x += by * random.symmetric();
  for (double& q : rigid.turn) q += by * random.symmetric();
}

/// Adds `count` bodies of any models in a cube.
std::vector<Rigid> add_rigid_bodies(Random& random, Play& play, int count, double size)
{
  std::vector<Rigid> all;
  for (int k = 0; k < count; ++k) {
    all.push_back(anywhere(random, size));
    const std::size_t model = play.any_model();
    play.add_body(model, all.back().pose());
  }
  return all;
}

Scene_case drifting(Random& random, double exponent)
{
  Play play(random);
  play.add_models(3, any_shape);
  auto bodies = add_rigid_bodies(random, play, 7, 1);
  return play.frames([&](int) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      drift(random, bodies[k], std::ldexp(1.0, int(exponent)));
      play.place(k, bodies[k].pose());
    }
  });
}

/// Meshes beside one another, nearer from frame to frame.
Scene_case close_meshes(Random& random, double exponent)
{
  Play play(random);
  for (int k = 0; k < 2; ++k) play.add_model(meshes()[play.one_below(meshes().size() - 1)].body);
  auto bodies = add_rigid_bodies(random, play, 4, 0.125);
  const double step = std::ldexp(1.0, int(exponent));
  for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k].at[k % 3] += (1 + 0.5 * random.unit()) * (k < 3 ? 1 : -1);
  return play.frames([&](int) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      for (double& x : bodies[k].at) x -= step * x;
      drift(random, bodies[k], step / 8);
      play.place(k, bodies[k].pose());
    }
  });
}

Scene_case jumping(Random& random, double one_in)
{
  Play play(random);
  play.add_models(3);
  auto bodies = add_rigid_bodies(random, play, 7, 1);
  return play.frames([&](int) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      if (!play.one_in(std::size_t(one_in))) {
        drift(random, bodies[k], 0x1p-10);
      } else {
        const bool is_far = play.one_in(4);
        bodies[k] = anywhere(random, is_far ? 0x1p40 : 1);
      }
      play.place(k, bodies[k].pose());
    }
  });
}

/// Some move, and now and then one goes back to where it stood two frames ago.
Scene_case resting(Random& random, double moving)
{
  Play play(random);
  play.add_models(3);
  auto bodies = add_rigid_bodies(random, play, 7, 1);
  std::vector<std::vector<Rigid>> before = {bodies};
  return play.frames([&](int frame) {
    for (int n = 0; n < int(moving); ++n) {
      const std::size_t k = play.one_below(bodies.size());
      if (frame > 1 && play.one_in(2))
        bodies[k] = before[std::size_t(frame) - 2][k];
      else
        drift(random, bodies[k], 0.25);
      play.place(k, bodies[k].pose());
    }
    before.push_back(bodies);
  });
}

/// Long thin boxes that turn through one another.
Scene_case thin(Random& random, double length)
{
  Play play(random);
  play.add_model(shared(box({-length, -0.125, -0.125}, {length, 0.125, 0.125})));
  play.add_model(shared(box({-0.25, -0.0625, -length / 2}, {0.25, 0.0625, length / 2})));
  auto bodies = add_rigid_bodies(random, play, 7, length / 2);
  return play.frames([&](int) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      drift(random, bodies[k], 0.03125);
      play.place(k, bodies[k].pose());
    }
  });
}

// --- on a grid, where bodies touch -----------------------------------------------------------------------------------

/// A turn that keeps the grid, then a translation by quarters.
Pose on_grid(Random& random, int size)
{
  const Pose turn = signed_permutation(integer(random, 0, 23));
  Exact_vector shift;
  for (Rational& x : shift) x = Rational(integer(random, -size, size)) / 4;
  return moved(turn, shift);
}

/// By a quarter along an axis, or not.
Pose grid_step(Random& random, const Pose& pose)
{
  Exact_vector shift{0, 0, 0};
  const int axis = integer(random, 0, 3);
  if (axis < 3) shift[std::size_t(axis)] = Rational(integer(random, 0, 1) * 2 - 1) / 4;
  return moved(pose, shift);
}

void add_grid_bodies(Random& random, Play& play, int count)
{
  for (int k = 0; k < count; ++k) {
    const std::size_t model = play.any_model();
    play.add_body(model, on_grid(random, 6));
  }
}

/// Moves one coordinate of a pose by `ulps` ulps of 1.
Pose nudged(Random& random, const Pose& pose, double ulps)
{
  Exact_vector shift{0, 0, 0};
  shift[std::size_t(integer(random, 0, 2))] = Rational(std::ldexp(ulps, -52));
  return moved(pose, shift);
}

/// Bodies that touch exactly, or are `ulps` ulps apart.
Scene_case on_a_grid(Random& random, double ulps)
{
  Play play(random);
  play.add_models(3);
  add_grid_bodies(random, play, 8);
  std::vector<Pose> at;
  for (std::size_t k = 0; k < play.body_count(); ++k) at.push_back(play.body(k)->pose);
  return play.frames([&](int) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = grid_step(random, at[k]);
      play.place(k, ulps != 0 && play.one_in(2) ? nudged(random, at[k], ulps) : at[k]);
    }
  });
}

/// The grid, turned by a rotation of fractions of integers up to `size`.
Scene_case on_a_turned_grid(Random& random, double size)
{
  Play play(random);
  play.add_models(3);
  add_grid_bodies(random, play, 6);
  const Pose common = moved(rational_rotation(random, int(size)), times(Rational(1) / 3, integer_direction(random, 9)));
  std::vector<Pose> at;
  for (std::size_t k = 0; k < play.body_count(); ++k) {
    at.push_back(play.body(k)->pose);
    play.place(k, composed(common, at[k]));
  }
  return play.frames([&](int) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = grid_step(random, at[k]);
      play.place(k, composed(common, at[k]));
    }
  });
}

/// Bodies come and go; what comes again may be of another model.
Scene_case coming_and_going(Random& random, double one_in)
{
  Play play(random);
  play.add_models(3);
  add_grid_bodies(random, play, 8);
  return play.frames([&](int) {
    for (std::size_t k = 0; k < play.body_count(); ++k) {
      auto& body = play.body(k);
      if (!play.one_in(std::size_t(one_in))) {
        if (body) play.place(k, grid_step(random, body->pose));
      } else if (body) {
        body.reset();
      } else {
        const std::size_t model = play.any_model();
        body = Scene_case::Standing{model, on_grid(random, 6)};
      }
    }
  });
}

/// Bodies change their models, where they stand or as they move.
Scene_case changing_models(Random& random, double moves)
{
  Play play(random);
  play.add_models(4, any_shape);
  add_grid_bodies(random, play, 7);
  return play.frames([&](int) {
    for (std::size_t k = 0; k < play.body_count(); ++k) {
      if (play.one_in(3)) play.body(k)->model = play.any_model();
      if (moves != 0) play.place(k, grid_step(random, play.body(k)->pose));
    }
  });
}

/// A scene in which `pairs` more pairs are ignored in each frame.
Scene_case ignoring(Random& random, double pairs)
{
  Play play(random);
  play.add_models(3);
  add_grid_bodies(random, play, 7);
  return play.frames([&](int) {
    for (int n = 0; n < int(pairs); ++n) {
      const std::size_t a = play.one_below(play.body_count()), b = play.one_below(play.body_count());
      if (a != b) play.ignore(a, b);
    }
    for (std::size_t k = 0; k < play.body_count(); ++k)
      if (play.one_in(2)) play.place(k, grid_step(random, play.body(k)->pose));
  });
}

/// Small bodies in cavities, in tunnels and in the solid, by steps of 2^-exponent.
Scene_case in_hollows(Random& random, double exponent)
{
  Play play(random);
  play.add_model(blocks()[cavity_block].body);
  play.add_model(blocks()[tunnel_block].body);
  play.add_models(2, any_pebble);
  play.add_body(0, Pose());
  play.add_body(1, moved(Pose(), {2, 0, 0}));
  const double step = std::ldexp(1.0, -int(exponent));
  const auto shift = [&](double by) {
    Exact_vector d;
    for (Rational& x : d) x = Rational(by * integer(random, -2, 2));
    return d;
  };
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t model = 2 + play.one_below(2);
    Exact_vector at = shift(0.125);
    if (k % 2 == 1) at[0] += 2;
    play.add_body(model, moved(Pose(), at));
  }
  return play.frames([&](int) {
    for (std::size_t k = 2; k < play.body_count(); ++k) play.place(k, moved(play.body(k)->pose, shift(step)));
  });
}

// --- of any size and form --------------------------------------------------------------------------------------------

/// Bodies from 2^-size to 1 large, on the corners, edges and faces of the unit cube's grid.
Scene_case of_many_sizes(Random& random, double size)
{
  Play play(random);
  play.add_models(3);
  const auto any = [&] {
    const double scale = std::ldexp(1.0, -int(size) * integer(random, 0, 2) / 2);
    Exact_vector at;
    for (Rational& x : at) x = Rational(integer(random, 0, 2)) / 2 + Rational(scale * integer(random, -1, 1));
    return moved(scaling(scale), at);
  };
  for (int k = 0; k < 8; ++k) {
    const std::size_t model = play.any_model();
    play.add_body(model, any());
  }
  return play.frames([&](int) {
    for (std::size_t k = 0; k < play.body_count(); ++k)
      if (play.one_in(2)) play.place(k, any());
  });
}

/// Poses that are no motions: turns, shears and reflections between stretches by up to 2^size.
Scene_case wild(Random& random, double size)
{
  Play play(random);
  play.add_models(3);
  for (int k = 0; k < 6; ++k) {
    const std::size_t model = play.any_model();
    play.add_body(model, wild_map(random, int(size)));
  }
  return play.frames([&](int) {
    for (std::size_t k = 0; k < play.body_count(); ++k)
      if (play.one_in(2)) play.place(k, wild_map(random, int(size)));
  });
}

/// Models with coordinates up to about 2^size, scaled by one power of two or by one per axis. Their origins are among
/// the vertices or far away. Poses of fractions bring them back onto a grid that is turned and far smaller.
Scene_case tiny_fractions(Random& random, double size)
{
  Play play(random);
  std::vector<Pose> back;  // onto the grid, of each model
  for (int k = 0; k < 3; ++k) {
    std::array<int, 3> exponents{int(size), int(size), int(size)};
    const bool is_shifted = play.one_in(3);
    if (!is_shifted && play.one_in(3))
      for (int& e : exponents) e = int(size) * integer(random, -1, 1);
    // Far from the origin, and still on the doubles' grid.
    const double shift = is_shifted ? std::ldexp(1.0, int(size) + 2) : 0;
    play.add_model(moved_copy(any_block(random), exponents, shift));
    const Pose shrunk = stretch({-exponents[0], -exponents[1], -exponents[2]});
    back.push_back(composed(shrunk, moved(Pose(), {Rational(-shift), Rational(-shift), Rational(-shift)})));
  }
  const std::array smaller = {0, integer(random, 25, 125), integer(random, 900, 1080)};
  const Pose common = fraction_map(random, -smaller[play.one_below(3)]);
  std::vector<std::size_t> model;
  std::vector<Pose> at;
  const auto placed = [&](std::size_t k) { return composed(common, composed(at[k], back[model[k]])); };
  for (std::size_t k = 0; k < 6; ++k) {
    model.push_back(play.any_model());
    at.push_back(on_grid(random, 6));
    play.add_body(model[k], placed(k));
  }
  return play.frames([&](int) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (play.one_in(3)) continue;
      at[k] = play.one_in(8) ? on_grid(random, 6) : grid_step(random, at[k]);
      play.place(k, placed(k));
    }
  });
}

std::vector<Scene_family> entries()
{
  return {
      {{"scene-drift", "bodies that drift and turn by small steps", "step 2^e: e", {-3, -6, -10, -20}}, drifting},
      {{"scene-meshes", "meshes close to one another, by small steps", "step 2^e: e", {-5, -7, -10}}, close_meshes},
      {{"scene-jumps", "bodies that jump now and then, some far away", "one in so many", {2, 4, 8}}, jumping},
      {{"scene-rests", "bodies that rest, and go back to where they stood", "how many move", {0, 1, 3}}, resting},
      {{"scene-thin", "long thin bodies that turn", "length", {2, 8, 32}}, thin},
      {{"scene-grid", "bodies on a grid, in exact contact", "ulps beside it", {0, 1, -1, 1024}}, on_a_grid},
      {{"scene-fractions",
        "a grid turned by a rotation of fractions, in exact contact",
        "integers of its quaternion up to",
        {1, 3, 9}},
       on_a_turned_grid},
      {{"scene-crowd", "bodies that come and go", "one in so many a frame", {2, 3, 5}}, coming_and_going},
      {{"scene-models", "bodies that change their models", "0 at rest, 1 as they move", {0, 1}}, changing_models},
      {{"scene-ignored", "pairs that are not asked for any more", "pairs a frame", {1, 3}}, ignoring},
      {{"scene-hollows", "bodies in cavities and tunnels", "step 2^-e: e", {3, 4, 10}}, in_hollows},
      {{"scene-sizes", "bodies of many sizes", "the least is 2^-e: e", {2, 10, 40, 300}}, of_many_sizes},
      {{"scene-wild", "poses that are no motions", "stretches up to 2^e: e", {1, 3, 30}}, wild},
      {{"scene-tiny-fractions",
        "huge models under fractions that are rounded to denormals, or to 0",
        "coordinates up to 2^e: e",
        {0, 500, 1000, 1008, 1015}},
       tiny_fractions},
  };
}

}  // namespace
}  // namespace scene_family

Scene_case Scene_family::scene_case(std::uint64_t seed, std::uint64_t index) const
{
  Random random = random_of_case(seed, (std::uint64_t(1) << 41) ^ std::uint64_t(number), index);
  const Origin of_case = origin(seed, index);
  Scene_case made = make(random, of_case.parameter);
  made.question = random.bits() % 2 == 0 ? kernel::Question::surface : kernel::Question::solid;
  made.origin = of_case;
  return made;
}

const std::vector<Scene_family>& scene_families()
{
  static const std::vector<Scene_family> all = numbered(scene_family::entries());
  return all;
}

}  // namespace tetracone::verify
