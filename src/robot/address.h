// Robot addresses as people type them (cli.md, "Robot addresses").
#pragma once

#include <QString>
#include <QUrl>
#include <tl/expected.hpp>

namespace mapwright::robot {

enum class Backend { Axbot, Demo };

/// A parsed address. `url` is the HTTP(S) base of the robot (port filled in), or the demo's query.
struct Address {
  Backend backend = Backend::Axbot;
  QUrl url;
  QString text;  // normalised: "axbot+http://192.0.2.7:8090", "demo:?scene=office"
};

/// Parses an address; the error is a sentence. Missing scheme means axbot+http, missing port 8090. An address
/// with a user or password in it is refused: secrets never go there. Schemes of robots that this version
/// cannot talk to yet (aimdk, kabam, rep130, file) are refused with a sentence that says so.
tl::expected<Address, QString> parseAddress(const QString& text);

}  // namespace mapwright::robot
