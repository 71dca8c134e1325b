#include "scene/write_picture.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImageWriter>

#include "disk/written_file.h"

namespace mapwright::scene {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(WritePicture)
};

}  // namespace

std::optional<QString> writePicture(const QImage& picture, const QString& path) {
  QBuffer png;
  png.open(QIODevice::WriteOnly);
  QImageWriter writer(&png, "png");
  if (!writer.write(picture)) {
    return Words::tr("The picture for %1 cannot be encoded: %2.").arg(path, writer.errorString());
  }
  const auto problem = disk::writeFile(
      path.toStdString(), std::string_view(png.data().constData(), std::size_t(png.data().size())));
  return problem ? std::optional(QString::fromStdString(*problem)) : std::nullopt;
}

}  // namespace mapwright::scene
