// What is never repeated of a server's words: the secret that it was given, and what rosauth proves it with.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <QByteArray>
#include <QString>

namespace mapwright::net {

/// Immutable; any thread.
class Unsaid {
 public:
  Unsaid() = default;
  /// Shorter secrets stay: they are part of other words.
  explicit Unsaid(const QByteArray& secret, std::size_t shortest = 4);

  /// Puts "***" in its place.
  void hideIn(std::string& words) const;
  void hideIn(QString& words) const;
  void hideIn(QByteArray& utf8) const;

 private:
  std::vector<std::string>
      forms_;  // as it is, in addresses, in JSON, as base64, as texts of robots are shown
};

}  // namespace mapwright::net
