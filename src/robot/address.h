// Robot addresses as people type them (docs/command-line.md, "Addresses"). What the addresses of one kind of
// robot look like is told by its adapter; which kinds there are, by the composition root.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>
#include <QUrl>
#include <QUrlQuery>
#include <tl/expected.hpp>

namespace mapwright::robot {

/// A parsed address.
struct Address {
  QString scheme;     // the prefix of its AddressScheme
  QString text;       // normalised, as it may be typed again; never with a secret
  QUrl url;           // HTTP(S) base of a robot on a network, port filled in; empty for all others
  QString path;       // absolute, of files on this computer; empty for all others
  QUrlQuery options;  // what follows the ?, as its scheme understands it
};

/// The error is a sentence.
using ParsedAddress = tl::expected<Address, QString>;

struct AddressScheme {
  QString prefix;  // "axbot+": what begins so is its address, whatever the case of the letters
  QString like;    // "axbot+http://HOST:8090", for sentences
  /// `rest` is what follows the prefix, or all that was typed where there is none.
  std::function<ParsedAddress(const QString& rest)> parse;
  /// Whether something without any prefix can only be an address of its; null: never.
  std::function<bool(const QString& typed)> claims = {};
  bool on_network = true;  // of a server: an @ in it tells of a user name, and nothing else
};

/// The addresses that this program understands. A value.
class Addresses {
 public:
  Addresses() = default;
  /// What no scheme claims is an address of the first.
  explicit Addresses(std::vector<AddressScheme> schemes) : schemes_(std::move(schemes)) {}
  /// An address with a user or password in it is refused, by a sentence that names it without them: secrets
  /// never go there. Schemes that nobody registered are refused with a sentence that names those that are.
  ParsedAddress parse(const QString& typed) const;
  /// Whether it begins like an address, of a kind that is registered or of one that is not: no name of a map.
  bool isAddress(const QString& typed) const;
  /// What an address of each kind looks like, the one that needs no prefix first.
  QStringList examples() const;

 private:
  std::vector<AddressScheme> schemes_;
};

/// An http or https address of a host with a port (`port` where none is given), without a password, a path
/// that ends in / or another scheme. `example`: of a whole address, for the sentence.
tl::expected<QUrl, QString> webAddress(const QString& rest, const QString& example, int port);

/// "192.0.2.7:8090": which server on the network it is; empty for what is on none.
QString hostOf(const Address& address);

/// The files that a map is read from at `address`: the one that it names, or `id` in the folder that it
/// names, and the map's picture (each where there is one). None of a robot.
std::vector<std::string> localFiles(const Address& address, const std::string& id,
                                    const std::string& picture);

}  // namespace mapwright::robot
