#ifndef TETRACONE_EXPERIMENTS_SUBJECTS_PLUGIN_H
#define TETRACONE_EXPERIMENTS_SUBJECTS_PLUGIN_H

#include <stddef.h>

// A compiled method as a shared object of these four C functions. plugin_host.cpp speaks the protocol for it, and times
// subject_ask alone. It is called by one thread; a process of its own is started for each thread of a campaign.

#ifdef __cplusplus
extern "C" {
#endif

/// Returns the method's name and version; the text stays.
const char* subject_name(void);

/// Keeps a body of triangles under its number. Returns 1, or 0 to decline all questions about it.
int subject_add(size_t body, size_t vertex_count, const double (*vertices)[3], size_t triangle_count,
                const unsigned (*triangles)[3]);

/// Returns 1 where the placed bodies share a point, touching counts; 0 where they do not; -1 to decline. Poses are
/// row-major 3x4, their fractions rounded. `solid` is 0 for the surfaces, 1 for the solids.
int subject_ask(size_t a, size_t b, const double pose_a[12], const double pose_b[12], int solid);

/// Frees the body; its number is not used again.
void subject_forget(size_t body);

#ifdef __cplusplus
}
#endif

#endif
