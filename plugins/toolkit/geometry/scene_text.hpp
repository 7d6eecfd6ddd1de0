// What writers of scene files in YAML share. Free functions; any thread.
#pragma once

#include <Eigen/Core>
#include <string>

namespace foothold::geometry {

// The shortest digits that read back as the same number, whatever the locale.
std::string number_text(double value);
std::string triple_text(const Eigen::Vector3d& v);  // "[x, y, z]"
std::string quoted(const std::string& text);        // one line, in double quotes

}  // namespace foothold::geometry
