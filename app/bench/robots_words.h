// Typical messages of robots for benchmarks of recording, and where to write them.
#pragma once

#include <cmath>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include <QString>

namespace mapwright::bench {

/// Not the folder for temporary files, which may be in memory.
inline QString folderOnDisk() { return QStringLiteral("/var/tmp/mapwright-bench-XXXXXX"); }

/// A scan of 720 rays followed by five poses, over and over.
inline const std::vector<std::string>& robotsWords() {
  static const std::vector<std::string> words = [] {
    std::mt19937 random(1);
    std::vector<std::string> made;
    const auto add = [](std::string& text, std::initializer_list<double> numbers) {
      char separator = '[';
      for (const double number : numbers) {
        text += separator;
        text += std::to_string(number);
        separator = ',';
      }
      text += ']';
    };
    for (int i = 0; i < 64; ++i) {
      std::string scan = R"({"topic": "/scan_matched_points2", "stamp": 1700000000.123, "points": [)";
      for (int ray = 0; ray < 720; ++ray) {
        const double range = 4 + std::sin(ray * 0.02 + i * 0.01) * 3 + double(random() % 100) * 1e-3;
        if (ray > 0) scan += ',';
        add(scan, {range * std::cos(ray * 0.00873), range * std::sin(ray * 0.00873)});
      }
      scan += "]}";
      made.push_back(std::move(scan));
      for (int pose = 0; pose < 5; ++pose) {
        std::string tracked = R"({"topic": "/tracked_pose", "pos": )";
        add(tracked, {double(random() % 10000) * 1e-3, i * 0.1});
        tracked += R"(, "ori": 1.57, "cov": [[0.0001, 0], [0, 0.0001]]})";
        made.push_back(std::move(tracked));
      }
    }
    return made;
  }();
  return words;
}

}  // namespace mapwright::bench
