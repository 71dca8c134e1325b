// Robot addresses as typed (docs/command-line.md, "Addresses"). The adapter of each kind of robot defines
// their form; the composition root lists the kinds.
#pragma once

#include <functional>
#include <optional>
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
  QString text;       // normalised, can be typed again; never contains a secret
  QUrl url;           // HTTP(S) base of a robot on a network, with port; otherwise empty
  QString path;       // absolute, for files on this computer; otherwise empty
  QUrlQuery options;  // the part after the ?, as defined by its scheme
};

/// A server where people believe a robot to be.
struct Host {
  QString name;             // "192.0.2.7", "dock-3.local", "fe80::1"
  std::optional<int> port;  // nullopt = the usual one of each kind
  QString path = {};        // of what a browser showed: "/robots/7"
  bool encrypted = false;   // it began with https
  bool operator==(const Host&) const = default;
};

/// The error is a sentence.
using ParsedAddress = tl::expected<Address, QString>;

struct AddressScheme {
  QString prefix;  // "axbot+": identifies its addresses, case-insensitive
  QString like;    // "axbot+http://HOST:8090", for sentences
  /// `rest` is the part after the prefix, or everything if there is none.
  std::function<ParsedAddress(const QString& rest)> parse;
  /// Whether text without a prefix can only be one of its addresses; null: never.
  std::function<bool(const QString& typed)> claims = {};
  bool on_network = true;  // of a server: an @ in it means a user name
  /// For forms; without a title this kind is not offered there.
  QString title = {};                      // "Autoxing"
  int port = 0;                            // the usual one
  QString plain = QStringLiteral("http");  // the scheme of its URLs
  QString encrypted = QStringLiteral("https");
};

/// The addresses that this program understands. A value.
class Addresses {
 public:
  Addresses() = default;
  /// Text that no scheme claims is an address of the first.
  explicit Addresses(std::vector<AddressScheme> schemes) : schemes_(std::move(schemes)) {}
  /// An address with a user or password is refused, with a sentence that does not repeat them: secrets never
  /// belong there. Unknown schemes are refused with a sentence that names the known ones.
  ParsedAddress parse(const QString& typed) const;
  /// Whether it begins like an address, of a known or unknown kind, and so is not the name of a map.
  bool isAddress(const QString& typed) const;
  /// The kind of robot that it names, "axbot"; empty where it is no address.
  std::string kindOf(const QString& typed) const;
  /// The title of that kind; empty where it has none.
  QString titleOf(const QString& typed) const;
  /// "192.0.2.7", with the port where it is not the usual one of its kind; empty for what is not on a
  /// network.
  QString hostShown(const QString& typed) const;
  /// An example address for each kind, the one that needs no prefix first.
  QStringList examples() const;
  const std::vector<AddressScheme>& schemes() const { return schemes_; }
  /// A host, perhaps with a port or copied from a browser: it does not say which kind of robot is there.
  /// nullopt: anything else, such as a complete address or a file.
  std::optional<Host> bareHost(const QString& typed) const;

 private:
  std::vector<AddressScheme> schemes_;
};

/// `scheme`://host:port, for an IPv6 address with brackets.
QUrl serverAt(const QString& scheme, const Host& host, int usual_port);

/// A sentence if a port in it is none; the first one counts.
std::optional<QString> noPortReason(const QString& typed);

/// An http or https address of a host with a port (by default `port`). No password, path or other scheme.
/// `example`: a complete address for the error.
tl::expected<QUrl, QString> webAddress(const QString& rest, const QString& example, int port);

/// "192.0.2.7:8090": its server on the network; empty for local ones.
QString hostOf(const Address& address);

/// The address of a robot of that kind there.
QString addressAt(const AddressScheme& scheme, const Host& host, bool encrypted);

/// The files that a map at `address` is read from: the file itself, or `id` in the folder, and the map's
/// picture (if they exist). None for a robot.
std::vector<std::string> localFiles(const Address& address, const std::string& id,
                                    const std::string& picture);

}  // namespace mapwright::robot
