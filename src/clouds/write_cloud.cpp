#include "clouds/write_cloud.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "clouds/draw_cloud.h"
#include "clouds/walk.h"

namespace mapwright::clouds {
namespace {

constexpr std::size_t kChunk = std::size_t(64) << 10;

struct Row {
  Eigen::Vector3d at;
  float intensity;
  std::uint32_t rgb;
};

/// A frame's name comes from a robot: characters that could end the header line are removed.
std::string headerWord(const std::string& text) {
  std::string word;
  for (const char c : text.substr(0, 100)) word += c > ' ' && c < 127 ? c : '_';
  return word;
}

class Output {
 public:
  Output(CloudFormat format, const CloudSink& sink) : format_(format), sink_(sink) {
    buffer_.reserve(kChunk + 512);
  }

  void header(const CloudWritten& fields, const std::string& frame) {
    fields_ = fields;
    switch (format_) {
      case CloudFormat::PcdBinary:
      case CloudFormat::PcdAscii:
        return pcdHeader(frame);
      case CloudFormat::PlyBinary:
        return plyHeader(frame);
      case CloudFormat::Csv:
        buffer_ += "x,y,z";
        if (fields_.intensity) buffer_ += ",intensity";
        if (fields_.rgb) buffer_ += ",red,green,blue";
        buffer_ += '\n';
    }
  }

  bool row(const Row& row) {
    if (format_ == CloudFormat::PcdAscii || format_ == CloudFormat::Csv) {
      textRow(row);
    } else {
      binaryRow(row);
    }
    return buffer_.size() < kChunk || flush();
  }

  bool flush() {
    if (!buffer_.empty()) good_ = good_ && sink_(buffer_);
    buffer_.clear();
    return good_;
  }

 private:
  void pcdHeader(const std::string& frame) {
    const std::string size = fields_.doubles ? "8 8 8" : "4 4 4", count = std::to_string(fields_.points);
    buffer_ += "# .PCD v0.7 - Point Cloud Data file format\n";
    if (!frame.empty()) buffer_ += "# frame " + headerWord(frame) + "\n";
    buffer_ += "VERSION 0.7\nFIELDS x y z";
    buffer_ += std::string(fields_.intensity ? " intensity" : "") + (fields_.rgb ? " rgb" : "");
    buffer_ += "\nSIZE " + size + (fields_.intensity ? " 4" : "") + (fields_.rgb ? " 4" : "");
    buffer_ += std::string("\nTYPE F F F") + (fields_.intensity ? " F" : "") + (fields_.rgb ? " U" : "");
    buffer_ += std::string("\nCOUNT 1 1 1") + (fields_.intensity ? " 1" : "") + (fields_.rgb ? " 1" : "");
    buffer_ += "\nWIDTH " + count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA ";
    buffer_ += format_ == CloudFormat::PcdAscii ? "ascii\n" : "binary\n";
  }

  void plyHeader(const std::string& frame) {
    buffer_ += "ply\nformat binary_little_endian 1.0\n";
    if (!frame.empty()) buffer_ += "comment frame " + headerWord(frame) + "\n";
    buffer_ += "element vertex " + std::to_string(fields_.points) + "\n";
    for (const char* const axis : {"x", "y", "z"}) {
      buffer_ += std::string("property ") + (fields_.doubles ? "double " : "float ") + axis + "\n";
    }
    if (fields_.intensity) buffer_ += "property float intensity\n";
    if (fields_.rgb) buffer_ += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    buffer_ += "end_header\n";
  }

  template <class Number>
  void text(Number value) {
    if constexpr (std::is_floating_point_v<Number>) {
      if (std::isnan(value)) {
        buffer_ += "nan";
        return;
      }
    }
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    buffer_.append(digits, end.ptr);
  }

  void textRow(const Row& row) {
    const char between = format_ == CloudFormat::Csv ? ',' : ' ';
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) buffer_ += between;
      if (fields_.doubles) {
        text(row.at[axis]);
      } else {
        text(float(row.at[axis]));
      }
    }
    if (fields_.intensity) {
      buffer_ += between;
      // In tables, unknown values are empty.
      if (format_ != CloudFormat::Csv || !std::isnan(row.intensity)) text(row.intensity);
    }
    if (fields_.rgb && format_ == CloudFormat::Csv) {
      for (const int shift : {16, 8, 0}) {
        buffer_ += between;
        text(row.rgb >> shift & 255);
      }
    } else if (fields_.rgb) {
      buffer_ += between;
      text(row.rgb);
    }
    buffer_ += '\n';
  }

  template <class Bits>
  void bits(Bits value) {
    for (std::size_t i = 0; i < sizeof value; ++i) buffer_ += char(value >> (8 * i) & 255);
  }

  void binaryRow(const Row& row) {
    for (int axis = 0; axis < 3; ++axis) {
      if (fields_.doubles) {
        bits(std::bit_cast<std::uint64_t>(row.at[axis]));
      } else {
        bits(std::bit_cast<std::uint32_t>(float(row.at[axis])));
      }
    }
    if (fields_.intensity) bits(std::bit_cast<std::uint32_t>(row.intensity));
    if (!fields_.rgb) return;
    if (format_ == CloudFormat::PcdBinary) {
      bits(row.rgb);
    } else {
      for (const int shift : {16, 8, 0}) buffer_ += char(row.rgb >> shift & 255);
    }
  }

  CloudFormat format_;
  const CloudSink& sink_;
  CloudWritten fields_;
  std::string buffer_;
  bool good_ = true;
};

constexpr float kNoIntensity = std::numeric_limits<float>::quiet_NaN();

}  // namespace

std::optional<CloudFormat> formatOf(std::string_view path) {
  std::string end(path.substr(path.size() - std::min<std::size_t>(4, path.size())));
  for (char& c : end) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  if (end == ".pcd") return CloudFormat::PcdBinary;
  if (end == ".ply") return CloudFormat::PlyBinary;
  if (end == ".csv") return CloudFormat::Csv;
  return std::nullopt;
}

std::optional<CloudWritten> writeCloud(const map::SpatialCloud& cloud, CloudFormat format,
                                       const CloudSink& sink, const std::atomic<bool>* cancelled) {
  CloudWritten written;
  written.points = cloud.points.size();
  written.doubles = cloud.origin_m != Eigen::Vector3d::Zero();
  written.intensity = !cloud.points.empty() && cloud.intensity.size() == cloud.points.size();
  written.rgb = !cloud.points.empty() && cloud.rgb.size() == cloud.points.size();
  Output output(format, sink);
  output.header(written, cloud.frame);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (i % 4096 == 0 && cancelled && *cancelled) return std::nullopt;
    if (!output.row({cloud.origin_m + cloud.points[i].cast<double>(),
                     written.intensity ? cloud.intensity[i] : kNoIntensity,
                     written.rgb ? cloud.rgb[i] : 0})) {
      return std::nullopt;
    }
  }
  return output.flush() ? std::optional(written) : std::nullopt;
}

std::optional<CloudWritten> writeClouds(const CloudSet& set, const HeightRange& heights, CloudFormat format,
                                        const CloudSink& sink, const std::atomic<bool>* cancelled) {
  CloudWritten written;
  std::string frame;
  for (const ShownCloud& cloud : set.clouds) {
    written.doubles = written.doubles || cloud.tree->origin() != Eigen::Vector3d::Zero();
    written.intensity = written.intensity || cloud.tree->hasIntensity();
    written.rgb = written.rgb || cloud.tree->hasRgb();
    if (frame.empty()) frame = cloud.tree->frame();
  }
  written.points = countShown(set, heights);
  Output output(format, sink);
  output.header(written, frame);
  bool good = true;
  for (const ShownCloud& cloud : set.clouds) {
    const CloudTree& tree = *cloud.tree;
    const Meant meant(tree, cloud.hidden, heights);
    walk(
        tree,
        [&](const CloudNode& node) {
          if (!good || (cancelled && *cancelled)) return Visit::Skip;
          return meant.of(node) == Visit::Skip ? Visit::Skip : Visit::Into;
        },
        [](const CloudNode&) {},
        [&](std::uint32_t i) {
          if (!good || !meant.has(tree.points()[i])) return;
          good = output.row({tree.world(i), tree.hasIntensity() ? tree.intensity()[i] : kNoIntensity,
                             tree.hasRgb() ? tree.rgb()[i] : 0});
        });
    if (!good || (cancelled && *cancelled)) return std::nullopt;
  }
  return output.flush() ? std::optional(written) : std::nullopt;
}

}  // namespace mapwright::clouds
