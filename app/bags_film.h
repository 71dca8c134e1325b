// `mapwright bags film`: what a bag holds, picture after picture, as PNG files or as a film (with ffmpeg).
#pragma once

#include <string>
#include <vector>

#include <QString>

#include "app/snapshot_options.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The words as typed; those of a single picture stand in `picture`, whose bag, at and output are not used.
struct FilmWords {
  SnapshotWords picture;
  std::string name, from, to;
  double every_s = 1, fps = 10;
};

/// The times of its pictures: `from_s`, and on every `every_s` until `to_s`.
std::vector<double> filmTimes(double from_s, double to_s, double every_s);
/// "frames/%05d.png" and 7 -> "frames/00007.png"; empty where there is no %d, %0Nd or more than one.
QString numbered(const QString& pattern, int number);

/// The options but those of a single picture.
void addFilm(CLI::App& command, FilmWords& words);
/// The exit code. Every picture is what `snapshot --bag NAME --at T` draws, in the view of the last of them.
int bagsFilm(const FilmWords& words, int& argc, char** argv);

}  // namespace mapwright::app
