// Files of the HTTP cache. Their checksum is set here, as it would be all that is found otherwise.
#include <cstring>
#include <filesystem>

#include <QUrl>

#include "net/http_cache.h"
#include "packed/codec.h"
#include "scratch.h"
#include "target.h"

namespace mapwright::fuzz::http_cache {
namespace {

using namespace net;

constexpr std::size_t kHeadBytes = 12;  // a signature of 8, a checksum of 4

struct Stored {
  ScratchFolder folder;
  QUrl url{QStringLiteral("http://h/a")};
  HttpCache cache{QString::fromStdString(folder.path() + "/cache"), 1 << 20,
                  [] { return QDateTime::fromMSecsSinceEpoch(1'700'000'000'000); }};
  std::string path;

  Stored() {
    cache.store(url, "body", "text/plain", "max-age=60", "\"e\"", false);
    cache.flush();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
      if (entry.path().extension() == ".answer") path = entry.path().string();
    }
    MUST(!path.empty());
  }
};

void read(Input input) {
  static Stored stored;
  std::string file = textOf(input);
  if (file.size() > kHeadBytes) {
    const Input rest(reinterpret_cast<const std::uint8_t*>(file.data()) + kHeadBytes,
                     file.size() - kHeadBytes);
    const std::uint32_t sum = packed::crc32(0, rest);
    for (std::size_t i = 0; i < 4; ++i) file[8 + i] = char(sum >> (24 - 8 * i));
  }
  ScratchFolder::writeTo(stored.path, {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()});
  const auto answer = stored.cache.find(stored.url);
  if (answer) MUST(answer->body.size() <= qsizetype(file.size()));
  stored.cache.flush();
}

}  // namespace
}  // namespace mapwright::fuzz::http_cache

MAPWRIGHT_FUZZ_TARGET(http_cache)
