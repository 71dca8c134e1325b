// The robot's secret: from a file or the environment, never from an argument (cli.md, "Robot addresses").
#pragma once

#include <QByteArray>
#include <QString>
#include <tl/expected.hpp>

namespace mapwright::app {

/// The content of `file` without surrounding blanks, else MAPWRIGHT_SECRET, else empty. The error is a
/// sentence that never holds the secret.
tl::expected<QByteArray, QString> readSecret(const QString& file);

}  // namespace mapwright::app
