#include "ui/overlays/collection_dialog.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "overlays/overlay_edits.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/status_text.h"
#include "ui/overlays/overlay_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using overlays::Feature;
using overlays::JsonKind;

namespace {

constexpr double kLargestM = 100;
constexpr std::array<const char*, CollectionDialog::kSizes> kSizeNames{
    "defaultRackWidth", "defaultRackDepth", "defaultPalletWidth", "defaultPalletDepth"};

/// 0: none that can be used.
double sizeIn(const Feature& collection, const char* name) {
  const auto value = collection.property(name);
  if (!value) return 0;
  double metres = value->number();
  if (value->kind() == JsonKind::String) {
    const std::string written = value->string();
    const auto [end, problem] = std::from_chars(written.data(), written.data() + written.size(), metres);
    if (problem != std::errc() || end != written.data() + written.size()) return 0;
  }
  return metres > 0 && metres <= kLargestM ? metres : 0;
}

}  // namespace

CollectionDialog::CollectionDialog(const Feature& collection, QWidget* parent)
    : QDialog(parent),
      before_(collection),
      apply_(new QPushButton(tr("Apply"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName(QStringLiteral("collectionDefaults"));
  setWindowTitle(tr("Defaults of the map"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QString names[] = {tr("Rack width"), tr("Rack depth"), tr("Pallet width"), tr("Pallet depth")};
  auto* const form = new QFormLayout;
  form->setHorizontalSpacing(12);
  for (std::size_t i = 0; i < kSizes; ++i) {
    boxes_[i] = numberField(this, {0, kLargestM, 3, 0.05, QStringLiteral(" m"), names[i], 100});
    boxes_[i]->setSpecialValueText(tr("not set"));
    boxes_[i]->setValue(sizeIn(before_, kSizeNames[i]));
    shown_[i] = boxes_[i]->value();  // as it is rounded
    form->addRow(names[i], boxes_[i]);
  }
  auto* const about = wrappedLabel(tr("Racks and pallets of this map have these sizes where nothing else is "
                                      "given. Can be undone; sent when "
                                      "you save."),
                                   this);
  auto* const column = columnOf({about, form}, 8);
  QStringList others;
  const auto properties = before_.root().member("properties");
  for (const auto& member : properties ? properties->children() : std::vector<overlays::JsonValue>()) {
    const std::string name = member.key();
    if (std::find(kSizeNames.begin(), kSizeNames.end(), name) == kSizeNames.end())
      others << plainWords(name, 60);
  }
  if (!others.isEmpty())
    column->addWidget(wrappedLabel(tr("Kept as they are: %1").arg(words::listed(others)), this));
  column->addStretch();
  column->addLayout(rowOf({LayoutItem::rest(), cancel_, apply_}, 8));
  setLayout(column);
  giveRoles(*apply_, {cancel_});
  connect(apply_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel_, &QPushButton::clicked, this, &QDialog::reject);
  resize(380, sizeHint().height());
}

Feature CollectionDialog::edited() const {
  Feature edited = before_;
  for (std::size_t i = 0; i < kSizes; ++i) {
    const double metres = boxes_[i]->value();
    if (metres == shown_[i]) continue;
    const auto before = before_.property(kSizeNames[i]);
    const std::string number = overlays::coordinateText(metres);
    const bool as_text = before && before->kind() == JsonKind::String;
    edited = overlays::withProperty(
        edited, kSizeNames[i],
        metres > 0 ? std::optional(as_text ? json::quoted(number) : number) : std::nullopt);
  }
  return edited;
}

}  // namespace mapwright::ui

#include "moc_collection_dialog.cpp"
