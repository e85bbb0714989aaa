#ifndef TETRACONE_EXPERIMENTS_VIEWER_VIEWER_FILES_H
#define TETRACONE_EXPERIMENTS_VIEWER_VIEWER_FILES_H

#include <string_view>

/// The files of experiments/viewer/page/ and three.js, as they were when the program was built: CMake writes their
/// definitions.
namespace tetracone::experiments::viewer {

extern const std::string_view page_html, pair_html, scene_html, style_css;
extern const std::string_view bodies_js, bounds_js, boxes_js, camera_js, pair_js, scene_js;
extern const std::string_view three_js;  ///< empty where Debian's libjs-three was not there

}  // namespace tetracone::experiments::viewer

#endif
