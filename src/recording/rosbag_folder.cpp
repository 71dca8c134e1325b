// A recording of rosbag2: a folder with metadata.yaml and one or several files, played as one. Source:
// rosbag2_storage, "metadata.yaml" (rosbag2_bagfile_information: relative_file_paths, in the order of time).
// It is written when the recording ends: a recorder that is killed leaves the files alone, NAME_0.db3,
// NAME_1.db3, …
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <sys/stat.h>
#include <tuple>
#include <utility>

#include <queue>

#include "disk/read_file.h"
#include "recording/opening.h"
#include "yaml/read_yaml.h"

namespace mapwright::recording {
namespace {

constexpr std::size_t kMostMetadata = std::size_t(4) << 20;
constexpr std::size_t kMostFiles = 1000;  // that are open at the same time

/// Channels of the parts, with numbers of their own.
class JoinedChannels {
 public:
  void add(std::size_t part, const Source& source) {
    for (const ChannelPtr& channel : source.channels()) {
      const auto [known, is_new] = of_part_.try_emplace({part, channel->id});
      if (!is_new) continue;
      const auto what = std::tuple(channel->topic, channel->message_encoding, channel->schema_name,
                                   channel->schema_encoding, channel->schema_data, channel->metadata);
      const auto [same, first] = by_content_.try_emplace(what, std::uint32_t(all_.size() + 1));
      known->second = same->second;
      if (!first) continue;
      auto own = std::make_shared<Channel>(*channel);
      own->id = same->second;
      all_.push_back(std::move(own));
    }
  }
  /// nullopt: not one of this part.
  std::optional<std::uint32_t> numberOf(std::size_t part, std::uint32_t id) const {
    const auto found = of_part_.find({part, id});
    return found == of_part_.end() ? std::nullopt : std::optional(found->second);
  }
  const ChannelPtr& at(std::uint32_t number) const { return all_[number - 1]; }
  const std::vector<ChannelPtr>& all() const { return all_; }

 private:
  std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> of_part_;
  std::map<std::tuple<std::string, std::string, std::string, std::string, std::string, Values>, std::uint32_t>
      by_content_;
  std::vector<ChannelPtr> all_;
};

class JoinedSource final : public Source {
 public:
  JoinedSource(std::vector<std::unique_ptr<Source>> parts, std::vector<Note> notes)
      : parts_(std::move(parts)), notes_(std::move(notes)) {
    lookAtChannels();
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      for (const AttachmentLocation& location : parts_[part]->attachments()) {
        attachments_.push_back(location);
        attachments_.back().offset = attached_.size();
        attached_.emplace_back(part, location);
      }
      const std::vector<Metadata>& metadata = parts_[part]->metadata();
      metadata_.insert(metadata_.end(), metadata.begin(), metadata.end());
    }
  }

  Summary summary() const override {
    Summary all;
    all.notes = notes_;
    all.finished = std::none_of(notes_.begin(), notes_.end(),
                                [](const Note& note) { return note.code == NoteCode::NoMetadata; });
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      const Summary one = parts_[part]->summary();
      if (part == 0) std::tie(all.profile, all.library) = std::tie(one.profile, one.library);
      if (one.start_ns) all.start_ns = std::min(all.start_ns.value_or(*one.start_ns), *one.start_ns);
      if (one.end_ns) all.end_ns = std::max(all.end_ns.value_or(*one.end_ns), *one.end_ns);
      all.messages += one.messages;
      for (const auto& [id, count] : one.messages_of) {
        if (const auto number = channels_.numberOf(part, id)) all.messages_of[*number] += count;
      }
      all.counted &= one.counted;
      all.chunks += one.chunks;
      all.bytes += one.bytes;
      all.finished &= one.finished;
      all.indexed &= one.indexed;
      for (const Note& note : one.notes) add(all.notes, note);
    }
    if (!all.counted) {
      all.messages = 0;
      all.messages_of.clear();
    }
    return all;
  }
  std::vector<ChannelPtr> channels() const override { return channels_.all(); }

  std::unique_ptr<Cursor> messages(const Query& query) override {
    return std::make_unique<JoinedCursor>(*this, query);
  }

  std::vector<Message> lastBefore(std::int64_t at_ns, const std::vector<std::string>& topics) override {
    std::map<std::string, Message> of_topic;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      for (Message& message : parts_[part]->lastBefore(at_ns, topics)) {
        Message& held = of_topic[message.channel->topic];
        // Of one time the later file's is the one that messages() gives last.
        if (!held.channel || held.log_time_ns <= message.log_time_ns) held = own(part, std::move(message));
      }
    }
    std::vector<Message> all;
    for (auto& [topic, message] : of_topic) all.push_back(std::move(message));
    return all;
  }

  std::map<std::uint32_t, std::int64_t> outermostTimes(const std::set<std::uint32_t>& channels,
                                                       bool last) override {
    std::map<std::uint32_t, std::int64_t> times;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      std::set<std::uint32_t> wanted;
      for (const ChannelPtr& channel : parts_[part]->channels()) {
        const auto number = channels_.numberOf(part, channel->id);
        if (number && channels.contains(*number)) wanted.insert(channel->id);
      }
      for (const auto& [id, time_ns] : parts_[part]->outermostTimes(wanted, last)) {
        const auto [at, is_new] = times.try_emplace(*channels_.numberOf(part, id), time_ns);
        if (!is_new) at->second = last ? std::max(at->second, time_ns) : std::min(at->second, time_ns);
      }
    }
    return times;
  }

  std::string format() const override { return parts_.front()->format(); }
  std::vector<Packing> packing() const override {
    std::map<std::string, Packing> by_name;
    for (const auto& part : parts_) {
      for (const Packing& one : part->packing()) {
        Packing& all = by_name[one.compression];
        all.compression = one.compression;
        all.chunks += one.chunks;
        all.packed_bytes += one.packed_bytes;
        all.unpacked_bytes += one.unpacked_bytes;
      }
    }
    std::vector<Packing> packing;
    for (auto& [name, all] : by_name) packing.push_back(std::move(all));
    return packing;
  }

  const std::vector<AttachmentLocation>& attachments() const override { return attachments_; }
  std::optional<Attachment> attachment(const AttachmentLocation& location) override {
    if (location.offset >= attached_.size()) return std::nullopt;
    const auto& [part, own] = attached_[std::size_t(location.offset)];
    return parts_[part]->attachment(own);
  }
  const std::vector<Metadata>& metadata() const override { return metadata_; }

  bool refresh() override {
    bool more = false;
    for (const auto& part : parts_) more |= part->refresh();
    if (more) lookAtChannels();
    return more;
  }

 private:
  /// The next message of a file.
  struct Head {
    std::size_t part = 0;
    Message message;
  };
  class JoinedCursor final : public Cursor {
   public:
    JoinedCursor(JoinedSource& source, const Query& query)
        : source_(source), heads_([backwards = query.backwards](const Head& a, const Head& b) {
            const auto key = [](const Head& head) { return std::pair(head.message.log_time_ns, head.part); };
            return backwards ? key(a) < key(b) : key(b) < key(a);
          }) {
      for (std::size_t part = 0; part < source.parts_.size(); ++part) {
        cursors_.push_back(source.parts_[part]->messages(query));
        advance(part);
      }
    }
    std::optional<Message> next() override {
      if (heads_.empty()) return std::nullopt;
      Head head = heads_.top();
      heads_.pop();
      advance(head.part);
      return source_.own(head.part, std::move(head.message));
    }

   private:
    void advance(std::size_t part) {
      if (auto message = cursors_[part]->next()) heads_.push({part, std::move(*message)});
    }
    JoinedSource& source_;
    std::vector<std::unique_ptr<Cursor>> cursors_;
    std::priority_queue<Head, std::vector<Head>, std::function<bool(const Head&, const Head&)>> heads_;
  };

  void lookAtChannels() {
    for (std::size_t part = 0; part < parts_.size(); ++part) channels_.add(part, *parts_[part]);
  }
  Message own(std::size_t part, Message message) {
    auto number = channels_.numberOf(part, message.channel->id);
    if (!number) {  // it turned up while reading
      channels_.add(part, *parts_[part]);
      number = channels_.numberOf(part, message.channel->id);
    }
    if (number) message.channel = channels_.at(*number);
    return message;
  }
  static void add(std::vector<Note>& notes, const Note& note) {
    const auto same = std::find_if(notes.begin(), notes.end(), [&](const Note& one) {
      return one.code == note.code && one.name == note.name;
    });
    if (same == notes.end()) {
      notes.push_back(note);
    } else {
      same->count += note.count;
    }
  }

  std::vector<std::unique_ptr<Source>> parts_;
  std::vector<Note> notes_;
  JoinedChannels channels_;
  std::vector<AttachmentLocation> attachments_;
  std::vector<std::pair<std::size_t, AttachmentLocation>> attached_;
  std::vector<Metadata> metadata_;
};

std::string withoutFolders(const std::string& path) { return path.substr(path.rfind('/') + 1); }

constexpr const char* kMetadataFile = "metadata.yaml";

/// "a_10.mcap.zstd": "a", 10. A number of -1: there is none; nullopt: no recording.
std::optional<std::pair<std::string, int>> numberedRecording(std::string name) {
  const auto drop = [&name](std::string_view end) {
    const bool has = name.size() > end.size() && name.ends_with(end);
    if (has) name.resize(name.size() - end.size());
    return has;
  };
  if (!drop(".zstd")) drop(".zst");
  if (!drop(".db3") && !drop(".mcap")) return std::nullopt;
  const std::size_t at = name.rfind('_');
  int number = -1;
  if (at == std::string::npos) return std::pair(name, number);
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + at + 1, end, number);
  if (error != std::errc() || stop != end) return std::pair(name, -1);
  return std::pair(name.substr(0, at), number);
}

/// The files that a recorder has written without getting to its metadata.yaml; none where there are maps, or
/// recordings of different names.
std::vector<std::string> filesOfOneRecording(const std::string& folder) {
  std::map<int, std::string> files;
  std::optional<std::string> of;
  std::error_code failed;
  for (std::filesystem::directory_iterator it(folder, failed), end; !failed && it != end;
       it.increment(failed)) {
    const std::string name = it->path().filename().string();
    if (name == kMetadataFile || name.starts_with('.')) continue;
    const std::string type = it->path().extension().string();
    for (const char* const of_maps : {".yaml", ".yml", ".png", ".pgm", ".bmp"})
      if (type == of_maps) return {};
    const auto numbered = numberedRecording(name);
    if (!numbered) continue;
    if (numbered->second < 0 || (of && *of != numbered->first)) return {};
    of = numbered->first;
    if (!files.emplace(numbered->second, name).second) return {};
  }
  std::vector<std::string> names;
  for (const auto& [number, name] : files) names.push_back(name);
  return names;
}

RosbagFolder undescribed(const std::string& folder) {
  RosbagFolder found;
  found.described = false;
  found.files = filesOfOneRecording(folder);
  if (found.files.size() > kMostFiles) {
    found.left_out = found.files.size() - kMostFiles;
    found.files.resize(kMostFiles);
  }
  return found;
}

RosbagFolder describedBy(const std::string& folder) {
  RosbagFolder said;
  std::vector<std::string>& files = said.files;
  const auto text = disk::readFile(folder + '/' + kMetadataFile, kMostMetadata + 1);
  const auto document =
      text ? yaml::readYaml(*text, {.most_bytes = kMostMetadata}) : tl::make_unexpected(yaml::Broken());
  if (!document) return said;
  try {
    const YAML::Node about = document->root["rosbag2_bagfile_information"];
    const YAML::Node paths = about["relative_file_paths"];
    if (!paths || !paths.IsSequence()) return said;
    if (const YAML::Node count = about["message_count"]) said.messages = count.as<std::uint64_t>(0);
    for (const YAML::Node& path : paths) {
      // Older releases wrote the folder, too; nothing outside of it is read.
      const std::string name = path.IsScalar() ? withoutFolders(path.Scalar()) : std::string();
      if (name.empty() || name == "." || name == "..") continue;
      if (std::find(files.begin(), files.end(), name) != files.end()) continue;
      files.size() < kMostFiles ? files.push_back(name) : void(++said.left_out);
    }
  } catch (const YAML::Exception&) {
    files.clear();
  }
  return said;
}

}  // namespace

RosbagFolder rosbagFolder(const std::string& folder) {
  RosbagFolder said = describedBy(folder);
  return said.files.empty() ? undescribed(folder) : said;
}

std::optional<std::string> rosbagFolderAt(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) return std::nullopt;
  if (S_ISDIR(about.st_mode)) return path;
  if (withoutFolders(path) != kMetadataFile) return std::nullopt;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash);
}

bool isRosbagFolder(const std::string& path) {
  const auto folder = rosbagFolderAt(path);
  return folder && !rosbagFolder(*folder).files.empty();
}

std::unique_ptr<Source> joined(std::vector<std::unique_ptr<Source>> parts, std::vector<Note> notes) {
  return std::make_unique<JoinedSource>(std::move(parts), std::move(notes));
}

std::unique_ptr<Source> noted(std::unique_ptr<Source> source, Note note) {
  std::vector<std::unique_ptr<Source>> parts;
  parts.push_back(std::move(source));
  return joined(std::move(parts), {std::move(note)});
}

}  // namespace mapwright::recording
