#ifndef TETRACONE_KERNEL_NUMBER_VERTEX_H
#define TETRACONE_KERNEL_NUMBER_VERTEX_H

#include <array>

namespace tetracone::kernel {

/// A point of a model, in the model's own frame. Each coordinate is a finite double and stands for exactly that
/// rational.
using Vertex = std::array<double, 3>;

}  // namespace tetracone::kernel

#endif
