#include "ui/plots/field_drag.h"

namespace mapwright::window {

std::unique_ptr<QMimeData> mimeOf(const PlotWish& wish) {
  auto mime = std::make_unique<QMimeData>();
  mime->setData(QLatin1String(kFieldMime), plotWord(wish).toUtf8());
  mime->setText(plotWord(wish));
  return mime;
}

std::optional<PlotWish> wishFromMime(const QMimeData& mime) {
  if (mime.hasFormat(QLatin1String(kFieldMime)))
    return plotFromWord(QString::fromUtf8(mime.data(QLatin1String(kFieldMime))));
  // Any text could be a topic; only one that begins like a path counts.
  const QString text = mime.hasText() ? mime.text().trimmed() : QString();
  if (!text.startsWith(QLatin1Char('/')) && !text.startsWith(QLatin1String("\"/"))) return std::nullopt;
  auto path = series::FieldPath::parse(text.toStdString());
  return path ? std::optional<PlotWish>(std::move(*path)) : std::nullopt;
}

}  // namespace mapwright::window
