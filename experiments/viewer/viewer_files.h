#ifndef TETRACONE_EXPERIMENTS_VIEWER_VIEWER_FILES_H
#define TETRACONE_EXPERIMENTS_VIEWER_VIEWER_FILES_H

#include <string_view>

/// The files of experiments/viewer/page/ and three.js, as they were when the program was built: CMake writes their
/// definitions.
namespace tetracone::experiments::viewer {

extern const std::string_view page_html, scene_html, notice_html, style_css;
extern const std::string_view errors_js, bodies_js, bounds_js, camera_js, page_js, scene_js;
extern const std::string_view three_js;  ///< empty where Debian's libjs-three was not there

}  // namespace tetracone::experiments::viewer

#endif
