// `mapwright bags …`: what a robot has recorded (docs/command-line.md).
#pragma once

#include <string>
#include <vector>

#include "app/robot_access.h"

namespace mapwright::app {

/// The options as typed; empty = not given. Times are seconds since the epoch, or ISO 8601.
struct BagsWords {
  std::string robot;
  AccessWords access;
  std::string name;                        // of a bag or a recording (mapwright bags list)
  std::string from, to, at;                // times
  std::vector<std::string> topics;         // frames, export: of these alone
  std::string kinds;                       // events: of these groups alone
  std::string output;                      // download: the file; "" = named after the bag. export, track
  std::string format;                      // export, track; "" = by the extension of the file
  std::string suffix, duration, category;  // record
  std::vector<std::string> files;          // merge: the inputs
  double every_s = 60;                     // split
  std::string report;
  double timeout_s = 300;
  bool json = false, yes = false, force = false;
};

/// The exit code (docs/command-line.md).
int bagsList(const BagsWords& words, int& argc, char** argv);
int bagsInfo(const BagsWords& words, int& argc, char** argv);
int bagsFrames(const BagsWords& words, int& argc, char** argv);
int bagsState(const BagsWords& words, int& argc, char** argv);
int bagsEvents(const BagsWords& words, int& argc, char** argv);
int bagsDownload(const BagsWords& words, int& argc, char** argv);
int bagsDelete(const BagsWords& words, int& argc, char** argv);
int bagsExport(const BagsWords& words, int& argc, char** argv);
int bagsTrack(const BagsWords& words, int& argc, char** argv);
int bagsRepair(const BagsWords& words, int& argc, char** argv);
int bagsSplit(const BagsWords& words, int& argc, char** argv);
int bagsMerge(const BagsWords& words, int& argc, char** argv);
int bagsRecord(const BagsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
