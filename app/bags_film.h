// `mapwright bags film`: a bag as a series of PNG files, or as a video made with ffmpeg.
#pragma once

#include <string>
#include <vector>

#include <QString>

#include "app/snapshot_options.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The options as typed; those of a single picture are in `picture`, whose bag, at and output are not used.
struct FilmWords {
  SnapshotWords picture;
  std::string name, from, to;
  double every_s = 1, fps = 10;
};

/// The times of its pictures: from `from_s` to `to_s` in steps of `every_s`.
std::vector<double> filmTimes(double from_s, double to_s, double every_s);
/// "frames/%05d.png" and 7 -> "frames/00007.png"; empty where there is no %d, %0Nd or more than one.
QString numbered(const QString& pattern, int number);

/// Adds the options, except those of a single picture.
void addFilm(CLI::App& command, FilmWords& words);
/// The exit code. Every picture is what `snapshot --bag NAME --at T` draws, all in the same view as the last
/// one.
int bagsFilm(const FilmWords& words, int& argc, char** argv);

}  // namespace mapwright::app
