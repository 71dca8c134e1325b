#include "net/openssl_exit.h"

#include <cstdint>

#include <QLibrary>

namespace mapwright::net {

void keepOpensslAtExit() {
  static const bool kept = [] {
    constexpr std::uint64_t kNoAtExit = 0x00080000;
    QLibrary crypto(QStringLiteral("crypto"), 3);  // that of Qt: it is not loaded twice
    using Init = int (*)(std::uint64_t, const void*);
    const auto init = reinterpret_cast<Init>(crypto.resolve("OPENSSL_init_crypto"));
    return init && init(kNoAtExit, nullptr) == 1;
  }();
  (void)kept;  // without the library there is nothing to keep
}

}  // namespace mapwright::net
