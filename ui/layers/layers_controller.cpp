#include "ui/layers/layers_controller.h"

#include <QActionGroup>
#include <QLineEdit>

#include "render/tile_colors.h"
#include "sentences/absence_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/findings.h"
#include "ui/kit/panels.h"
#include "ui/kit/plain_label.h"
#include "ui/layers/layer_settings.h"
#include "ui/layers/layers_dock.h"
#include "ui/layers/legend_dock.h"
#include "ui/layers/preset_menu.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {

LayersController::LayersController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      dock_(new LayersDock(&context.scene, &context.window)),
      legend_(new LegendDock(&context.scene, &context.window)),
      presets_(new PresetMenu(context.scene, context.settings, context.actions, context.window, this)),
      modes_(new QActionGroup(this)),
      colors_(new QActionGroup(this)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Left, .tab = 20, .menu_rank = 20});
  context_.panels.add(legend_,
                      {.side = PanelPosition::Side::Left, .tab = 30, .menu_rank = 25, .open = false});
  dock_->setPresets(presets_->menu());
  context_.findings.add([this]() -> Findings::Search {
    return [this](const QString&, const Findings::See& see) {
      for (const scene::Layer layer : scene::allLayers()) {
        see({scene::layerTitle(layer), tr("Layer"), QStringLiteral("layers"), [this, layer] {
               context_.panels.open(dock_);
               dock_->filterField()->setText(scene::layerTitle(layer));
               dock_->filterField()->setFocus();
             }});
      }
    };
  });
  addModes();
  addSwitch({.id = "grid",
             .text = tr("&Grid"),
             .name = tr("Show the grid"),
             .icon = "grid",
             .keys = {"G"},
             .tip = tr("Show the metric grid"),
             .menu = {MenuGroup::Drawn, 10},
             .bar = {BarGroup::Drawn, 10}},
            scene::Layer::Grid);
  addSwitch({.id = "showIds",
             .text = tr("Submap &ids"),
             .name = tr("Show the ids of submaps"),
             .icon = "ids",
             .keys = {"I"},
             .tip = tr("Show the ids of the submaps on the map"),
             .menu = {MenuGroup::Drawn, 20},
             .bar = {BarGroup::Drawn, 20}},
            scene::Layer::Ids);
  addSwitch({.id = "showOutlines",
             .text = tr("Submap &outlines"),
             .name = tr("Show the outlines of submaps"),
             .icon = "outlines",
             .keys = {"O"},
             .tip = tr("Show the outlines of the submaps on the map"),
             .menu = {MenuGroup::Drawn, 30},
             .bar = {BarGroup::Drawn, 30}},
            scene::Layer::Outlines);
  addColors();
  connect(&context_.scene, &scene::MapScene::layersChanged, this, &LayersController::sync);
  connect(dock_, &LayersDock::topicsChosen, this, [this](const robot::TopicChoices& choices) {
    if (const session::Session* const session = context_.current.session())
      saveTopics(choices, session->robot().address(), context_.settings);
  });
  connect(presets_, &PresetMenu::chosen, this, &LayersController::applyPreset);
  connect(dock_, &LayersDock::zoomWanted, this, &LayersController::zoomTo);
  connect(&context_.current, &CurrentSession::stateChanged, this, [this] {
    if (!context_.current.session()) endMode();
    syncModes();
  });
}

QAction* LayersController::addSwitch(const ActionSpec& spec, scene::Layer layer) {
  ActionSpec whole = spec;
  whole.reach = Reach::OutsideText;
  whole.toggle = true;
  QAction* const action = context_.actions.add(
      whole, this, [this, layer](bool on) { context_.scene.setLayerVisible(layer, on); });
  switches_.push_back({action, layer});
  return action;
}

void LayersController::addModes() {
  // Neither is possible, too: both layers can be hidden in the list.
  modes_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  const auto mode = [this](ActionSpec spec, ViewMode which, int rank) {
    spec.reach = Reach::OutsideText;
    spec.toggle = true;
    spec.menu = {MenuGroup::Maps, rank};
    spec.bar = {BarGroup::Maps, rank};
    QAction* const action = context_.actions.add(spec, this, [this, which] { setMode(which); });
    action->setData(int(which));
    action->setProperty("tip", action->toolTip());
    modes_->addAction(action);
  };
  mode({.id = "modeSubmaps",
        .text = tr("&Submaps"),
        .name = tr("Show the submaps"),
        .icon = "submaps",
        .keys = {"1"},
        .tip = tr("Show the submaps")},
       ViewMode::Submaps, 10);
  mode({.id = "modeWhole",
        .text = tr("&Whole map"),
        .name = tr("Show the whole map"),
        .icon = "map",
        .keys = {"2"},
        .tip = tr("Show the whole map")},
       ViewMode::Whole, 20);
  mode({.id = "modeBoth",
        .text = tr("&Both"),
        .name = tr("Show the whole map below the submaps"),
        .icon = "layers",
        .keys = {"3"},
        .tip = tr("Show the whole map below the submaps")},
       ViewMode::Both, 30);
}

void LayersController::addColors() {
  const auto colors = [this](const char* id, const QString& text, render::ColorMode mode, int rank,
                             const QString& tip) {
    QAction* const action = context_.actions.add(
        {.id = id, .text = text, .tip = tip, .toggle = true, .menu = {MenuGroup::Colors, rank}}, this,
        [this, mode] { setColorMode(mode); });
    action->setData(int(mode));
    colors_->addAction(action);
  };
  colors("colorsNormal", tr("Normal colours"), render::ColorMode::Normal, 10, tr("Plain grey"));
  colors("colorsIncremental", tr("Tint incremental submaps"), render::ColorMode::Incremental, 20,
         tr("Incremental submaps in blue and red"));
  colors("colorsActive", tr("Dim frozen submaps"), render::ColorMode::Active, 30,
         tr("Only active submaps at full strength"));
  colors("colorsTrajectory", tr("Colour by trajectory"), render::ColorMode::Trajectory, 40,
         tr("Each trajectory in a colour of its own"));
  colors("colorsAge", tr("Colour by age"), render::ColorMode::Age, 50,
         tr("Older and newer submaps of each trajectory"));
  colors("colorsVersion", tr("Colour by version"), render::ColorMode::Version, 60,
         tr("Submaps with few scans and with many"));
}

void LayersController::setMode(ViewMode mode) {
  setViewMode(context_.scene, mode);
  syncModes();
}

void LayersController::setColorMode(render::ColorMode mode) {
  context_.scene.setColorMode(mode);
  for (QAction* action : colors_->actions()) {
    if (action->data().toInt() == int(mode)) action->setChecked(true);
  }
  Q_EMIT colorModeChanged(mode);
}

void LayersController::setSession(session::Session* session) {
  if (robot::OffersTopics* const of = session ? robot::topicsOfferedBy(session->robot()) : nullptr)
    of->choose(savedTopics(session->robot().address(), context_.settings));
  dock_->endSolo();
  dock_->setSession(session);
  legend_->setSession(session);
  if (session) beginMode(*session);
  sayColors(session);
}

/// Colours that were chosen for another robot must not be taken for what this one says.
void LayersController::sayColors(session::Session* session) {
  const QAction* const chosen = colors_->checkedAction();
  const bool tinted = chosen && context_.scene.colorMode() != render::ColorMode::Normal;
  ToastStack* const toasts = context_.overlay.toasts();
  if (!said_colors_.isEmpty()) toasts->withdraw(said_colors_);
  said_colors_.clear();
  if (!session || !tinted || !session->robot().submapSource()) return;
  said_colors_ = tr("Colours as before: %1").arg(plainActionText(*chosen));
  toasts->add(Mark::Neutral, said_colors_,
              {tr("Normal colours"), [this] { setColorMode(render::ColorMode::Normal); }});
}

void LayersController::recall(const QSettings& settings) {
  restoreLayers(context_.scene, settings);
  dock_->restoreFolds(settings);
  const std::string colors = settings.value(QStringLiteral("view/colors")).toString().toStdString();
  setColorMode(render::colorModeFrom(colors).value_or(render::ColorMode::Normal));
  sync();
}

void LayersController::save(QSettings& settings) {
  const std::string_view colors = render::nameOf(context_.scene.colorMode());
  settings.setValue(QStringLiteral("view/colors"), QLatin1String(colors.data(), qsizetype(colors.size())));
  dock_->saveFolds(settings);
  // Both are taken back, and would have to be now.
  if (!dock_->solo() && !mode_before_) saveLayers(context_.scene, settings);
}

void LayersController::remember(QSettings& settings) {
  save(settings);
  dock_->endSolo();  // nobody could end it at the next start
  // A robot without submaps must not determine what the next one shows.
  const bool forced = mode_before_.has_value();
  endMode();
  saveLayers(context_.scene, settings);
  if (session::Session* const session = context_.current.session(); forced && session) beginMode(*session);
}

void LayersController::reset() {
  dock_->forgetSolo();
  dock_->resetFolds();
  resetOrderAndStyles(context_.scene);
  resetVisibility(context_.scene);
  if (mode_before_) setMode(ViewMode::Whole);
  setColorMode(render::ColorMode::Normal);
}

void LayersController::sync() {
  for (const Switch& one : switches_) one.action->setChecked(context_.scene.layerVisible(one.layer));
  syncModes();
}

void LayersController::syncModes() {
  const auto mode = viewMode(context_.scene);
  session::Session* const session = context_.current.session();
  const bool only_whole = session && !session->robot().submapSource();
  for (QAction* action : modes_->actions()) {
    const auto which = ViewMode(action->data().toInt());
    action->setChecked(mode == which);
    const bool possible = !only_whole || which == ViewMode::Whole;
    action->setEnabled(possible);
    action->setToolTip(possible ? action->property("tip").toString()
                                : plainToolTip(sentences::absenceReason(
                                      robot::Capability::Submaps,
                                      session->robot().unavailableReason(robot::Capability::Submaps))));
  }
}

void LayersController::applyPreset() {
  dock_->forgetSolo();
  // A preset made with another robot may show submaps that this one does not have.
  session::Session* const session = context_.current.session();
  if (session && !session->robot().submapSource() && !context_.scene.layerVisible(scene::Layer::WholeMap))
    setMode(ViewMode::Whole);
}

void LayersController::zoomTo(scene::Layer layer) {
  constexpr double kAroundM = 0.5, kClosestMPerPx = 0.02;
  const geometry::WorldRect bounds = context_.scene.layerBounds(layer);
  if (!bounds.empty()) context_.view.fit(bounds.grown(kAroundM), true, kClosestMPerPx);
}

void LayersController::beginMode(session::Session& session) {
  if (session.robot().submapSource()) {
    endMode();
  } else {
    if (!mode_before_) mode_before_ = viewMode(context_.scene).value_or(ViewMode::Submaps);
    setMode(ViewMode::Whole);
  }
  syncModes();
}

void LayersController::endMode() {
  if (!mode_before_) return;
  const ViewMode before = *mode_before_;
  mode_before_.reset();
  setMode(before);
}

}  // namespace mapwright::ui

#include "moc_layers_controller.cpp"
