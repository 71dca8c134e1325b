#include "ui/layers/preset_menu.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

/// Names of actions must not have a mnemonic by accident.
QString literally(QString name) { return name.replace(QLatin1Char('&'), QLatin1String("&&")); }

bool sameName(const QString& one, const QString& other) {
  return one.compare(other, Qt::CaseInsensitive) == 0;
}

constexpr std::array kBuiltInIds{"layersNavigation", "layersMapping", "layersMapOnly", "layersAll"};

}  // namespace

PresetNameDialog::PresetNameDialog(const QString& title, const QString& name, bool may_replace,
                                   std::function<Taken(const QString&)> taken, QWidget* parent)
    : QDialog(parent),
      yes_text_(may_replace ? tr("Save") : tr("Rename")),
      may_replace_(may_replace),
      taken_(std::move(taken)),
      field_(new QLineEdit(name, this)),
      note_(wrappedLabel({}, this)),
      yes_(new QPushButton(yes_text_, this)) {
  setWindowTitle(title);
  setMinimumWidth(380);
  auto* label = new QLabel(tr("&Name"), this);
  label->setBuddy(field_);
  setLongest(*field_, PresetMenu::kLongestName);
  field_->selectAll();
  note_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  note_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  giveRoles(*yes_, {cancel});
  setLayout(columnOf({label, field_, note_, LayoutItem::gap(4), rowOf({LayoutItem::rest(), cancel, yes_}, 8)},
                     8, QMargins(16, 16, 16, 16)));
  connect(field_, &QLineEdit::textChanged, this, &PresetNameDialog::check);
  connect(yes_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  check();
}

QString PresetNameDialog::name() const { return words::plainLine(field_->text()).simplified(); }

void PresetNameDialog::check() {
  const Taken taken = taken_(name());
  const bool replaces = taken == Taken::Own && may_replace_;
  QString note;
  if (taken == Taken::BuiltIn) note = tr("This preset is always there. Choose another name.");
  if (taken == Taken::Own)
    note = may_replace_ ? tr("Replaces your preset of this name.")
                        : tr("Another of your presets has this name.");
  note_->setText(note);
  setTextColor(*note_, note.isEmpty() || replaces ? appColors().secondary_text : appColors().error_text);
  yes_->setText(replaces ? tr("Replace") : yes_text_);
  yes_->setEnabled(!name().isEmpty() && (taken == Taken::No || replaces));
}

PresetMenu::PresetMenu(scene::MapScene& scene, QSettings& settings, Actions& actions, QWidget& window,
                       QObject* parent)
    : QObject(parent),
      scene_(scene),
      settings_(settings),
      actions_(actions),
      window_(window),
      built_in_(builtInPresets()),
      own_(savedPresets(settings)),
      menu_(new QMenu(tr("Layer &presets"), &window)) {
  menu_->setObjectName(QStringLiteral("layerPresets"));
  menu_->setToolTipsVisible(true);
  menu_->menuAction()->setObjectName(QStringLiteral("layerPresetsMenu"));
  actions_.addToMenu({MenuGroup::Drawn, 40}, menu_->menuAction());
  for (std::size_t i = 0; i < built_in_.size(); ++i)
    built_in_actions_.push_back(offer(QLatin1String(kBuiltInIds[i]), built_in_[i]));
  save_ = actions_.add(menuName(Menu::View), QStringLiteral("saveLayerPreset"),
                       tr("&Save the layers as a preset…"), {}, {}, Reach::Everywhere,
                       tr("Save which layers are shown, and how they are drawn"));
  connect(save_, &QAction::triggered, this, &PresetMenu::askForName);
  connect(&scene_, &scene::MapScene::layersChanged, this, &PresetMenu::mark);
  changed();
}

PresetMenu::~PresetMenu() {
  for (QAction* const action : own_actions_) actions_.remove(action);
}

std::vector<LayerPreset>::iterator PresetMenu::find(const QString& name) {
  return std::find_if(own_.begin(), own_.end(),
                      [&](const LayerPreset& preset) { return sameName(preset.name, name); });
}

QAction* PresetMenu::offer(const QString& id, const LayerPreset& preset) {
  QAction* const action =
      actions_.addToggle(menuName(Menu::View), id, tr("Layers: %1").arg(literally(preset.name)), {}, {},
                         Reach::Everywhere, tr("Show the layers of this preset"));
  connect(action, &QAction::triggered, this, [this, preset] { choose(preset); });
  return action;
}

void PresetMenu::changed() {
  menu_->clear();
  // One of them may be what has just been chosen from.
  for (QMenu* const old : menu_->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly))
    old->deleteLater();
  for (QAction* const action : std::exchange(own_actions_, {})) actions_.remove(action);
  for (const LayerPreset& preset : own_)
    own_actions_.push_back(offer(QStringLiteral("layerPreset-") + preset.name, preset));
  for (QAction* const action : built_in_actions_) menu_->addAction(action);
  if (!own_.empty()) menu_->addSeparator();
  for (QAction* const action : own_actions_) menu_->addAction(action);
  menu_->addSeparator();
  menu_->addAction(save_);
  if (!own_.empty()) {
    QMenu* const renaming = menu_->addMenu(tr("&Rename"));
    QMenu* const removing = menu_->addMenu(tr("&Delete"));
    for (const LayerPreset& preset : own_) {
      const QString name = preset.name;
      renaming->addAction(tr("%1…").arg(literally(name)), this, [this, name] { askForOtherName(name); });
      removing->addAction(literally(name), this, [this, name] { remove(name); });
    }
  }
  mark();
}

void PresetMenu::mark() {
  const auto each = [this](const std::vector<LayerPreset>& presets, const std::vector<QAction*>& actions) {
    for (std::size_t i = 0; i < presets.size(); ++i) actions[i]->setChecked(matches(scene_, presets[i]));
  };
  each(built_in_, built_in_actions_);
  each(own_, own_actions_);
}

void PresetMenu::choose(const LayerPreset& preset) {
  apply(scene_, preset);
  Q_EMIT chosen();
}

void PresetMenu::save(const QString& name) {
  LayerPreset preset = presetOf(scene_, name);
  const auto known = find(name);
  known == own_.end() ? own_.push_back(std::move(preset)) : void(*known = std::move(preset));
  savePresets(own_, settings_);
  changed();
}

void PresetMenu::rename(const QString& from, const QString& to) {
  const auto preset = find(from);
  if (preset == own_.end()) return;
  preset->name = to;
  savePresets(own_, settings_);
  changed();
}

void PresetMenu::remove(const QString& name) {
  const auto preset = find(name);
  if (preset == own_.end()) return;
  own_.erase(preset);
  savePresets(own_, settings_);
  changed();
}

PresetNameDialog* PresetMenu::open(const QString& title, const QString& name,
                                   std::function<void(QString)> done) {
  if (dialog_) {
    dialog_->raise();
    return dialog_;
  }
  using Taken = PresetNameDialog::Taken;
  const auto taken = [this, name](const QString& wanted) {
    if (std::any_of(built_in_.begin(), built_in_.end(),
                    [&](const LayerPreset& preset) { return sameName(preset.name, wanted); }))
      return Taken::BuiltIn;
    const bool itself = !name.isEmpty() && sameName(wanted, name);
    return !itself && find(wanted) != own_.end() ? Taken::Own : Taken::No;
  };
  dialog_ = new PresetNameDialog(title, name, name.isEmpty(), taken, &window_);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &QDialog::accepted, this,
          [dialog = dialog_.data(), done = std::move(done)] { done(dialog->name()); });
  dialog_->open();
  return dialog_;
}

PresetNameDialog* PresetMenu::askForName() {
  return open(tr("Save the layers as a preset"), {}, [this](const QString& name) { save(name); });
}

PresetNameDialog* PresetMenu::askForOtherName(const QString& name) {
  return open(tr("Rename the preset"), name, [this, name](const QString& to) { rename(name, to); });
}

}  // namespace mapwright::ui

#include "moc_preset_menu.cpp"
