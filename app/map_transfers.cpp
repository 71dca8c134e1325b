// `mapwright maps download|upload|create|set-image`: whole maps on their way (docs/command-line.md).
#include <vector>

#include <CLI/CLI.hpp>
#include <QJsonObject>

#include "app/command_map.h"
#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_command.h"
#include "app/robot_factory.h"
#include "grids/grid_cells.h"
#include "grids/grid_pyramid.h"
#include "jobs/change_map.h"
#include "jobs/map_folder.h"
#include "jobs/new_map.h"
#include "robot/map_transfer.h"
#include "robot/picture_store.h"
#include "sentences/plural.h"
#include "ui/kit/status_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

struct TransferArguments : RobotArguments {
  std::string id, folder, name, image, resolution, origin;
  bool force = false, as_new = false;
};

CommandResult<robot::MapTransfer*> transferOf(RobotReading& reading) {
  if (robot::MapTransfer* const transfer = reading.session().robot().mapTransfer()) return transfer;
  return passOn(CommandResult<int>(reading.lacks(robot::Capability::MapTransfer)));
}

void showProgress(const robot::Call& call, const std::shared_ptr<ProgressLine>& line) {
  call.onProgress([line](robot::Progress progress) {
    const QString of = progress.of_bytes ? ui::bytesText(*progress.of_bytes) : QStringLiteral("?");
    line->tell(Text::tr("%1 of %2").arg(ui::bytesText(progress.bytes), of));
  });
}

CommandResult<int> mapsDownload(RobotCommand& command, const TransferArguments& args) {
  const map::MapKey key = map::mapKeyFromText(args.id);
  if (key.kind != map::MapKind::Stored || !isPlainId(key.id))
    return wrong(Text::tr("%1: pass the id of a stored map (see mapwright maps list).").arg(text(args.id)));
  const QString folder = text(args.folder);
  if (const QString why = jobs::noMapFolderReason(folder, args.force); !why.isEmpty()) {
    const bool forced = !args.force && jobs::noMapFolderReason(folder, true).isEmpty();
    return wrong(forced ? QStringLiteral("%1 %2").arg(why, Text::tr("--force replaces it.")) : why);
  }
  const auto opened = command.open();
  if (!opened) return passOn(opened);
  RobotReading& reading = **opened;
  const auto transfer = transferOf(reading);
  if (!transfer) return passOn(transfer);
  const auto line = std::make_shared<ProgressLine>();  // the robot may report progress after the end
  const auto done = reading.ask<jobs::DownloadedMap>([&](robot::OutcomeTo<jobs::DownloadedMap> reply) {
    robot::Call call = jobs::downloadMap(**transfer, key, folder, std::move(reply));
    showProgress(call, line);
    return call;
  });
  line->clear();
  if (!done) {
    const auto failure = reading.failure(done.error());
    if (jobs::isAboutFiles(done.error())) return wrong(failure.value().sentence);
    return failure;
  }
  if (args.json) {
    printJson(QJsonObject{{QStringLiteral("id"), text(done->facts.key.id)},
                          {QStringLiteral("name"), text(done->facts.name)},
                          {QStringLiteral("folder"), done->folder},
                          {QStringLiteral("bytes"), qint64(done->bytes)},
                          {QStringLiteral("resumed"), done->resumed},
                          {QStringLiteral("data"), done->has_data}});
  } else {
    printLine(
        QStringLiteral("%1: %2, %3")
            .arg(oneLine(done->folder), words::plainName(done->facts.name), ui::bytesText(done->bytes)));
  }
  if (!done->has_data)
    say(
        Text::tr("The robot has no data for this map by which it positions itself: only its picture and its "
                 "overlays were downloaded."));
  return kDone;
}

/// Adds it and says what the robot holds.
CommandResult<int> addMap(RobotCommand& command, const TransferArguments& args, const robot::NewMap& map) {
  const auto opened = command.open();
  if (!opened) return passOn(opened);
  RobotReading& reading = **opened;
  const auto transfer = transferOf(reading);
  if (!transfer) return passOn(transfer);
  const auto maps = reading.catalogue();
  const QString remark =
      maps ? jobs::alsoCalledSo({.change = robot::MapChange::Save, .name = map.name}, **maps) : QString();
  if (!remark.isEmpty()) reading.addRemark(reading.about(remark));
  const auto line = std::make_shared<ProgressLine>();
  const auto held = reading.ask<robot::MapParts>([&](robot::OutcomeTo<robot::MapParts> reply) {
    robot::Call call = (*transfer)->add(map, std::move(reply));
    showProgress(call, line);
    return call;
  });
  line->clear();
  if (!held) {
    map::Failure failure = held.error();
    failure.asked_for = map::AskedFor::Addition;
    auto said = reading.failure(failure);
    if (failure.kind == map::FailureKind::Conflict)
      said.value().sentence += QLatin1Char(' ') + Text::tr("--as-new adds it as another map.");
    return said;
  }
  const robot::MapFacts* const now = &held->facts;
  const QStringList odd = jobs::differences(map, *held);
  if (args.json) {
    printJson(QJsonObject{{QStringLiteral("id"), text(now->key.id)},
                          {QStringLiteral("name"), text(now->name)},
                          {QStringLiteral("uid"), text(now->uid)},
                          {QStringLiteral("as_sent"), odd.isEmpty()}});
  } else {
    printLine(QStringLiteral("%1  %2").arg(words::plainName(now->key.id), words::plainName(now->name)));
  }
  if (odd.isEmpty()) return kDone;
  return reading.failure(
      kIncomplete,
      Text::tr("The robot accepted the map, but stored it differently: %1.").arg(words::joined(odd)));
}

CommandResult<int> mapsUpload(RobotCommand& command, const TransferArguments& args) {
  auto map = jobs::readMapFolder(text(args.folder), args.as_new);
  if (!map) return wrong(map.error());
  if (!args.name.empty()) {
    if (const QString why = jobs::noMapNameReason(text(args.name)); !why.isEmpty()) return wrong(why);
    map->name = args.name;
  }
  return addMap(command, args, *map);
}

CommandResult<int> mapsCreate(RobotCommand& command, const TransferArguments& args) {
  const auto resolution = numbersFrom(args.resolution), origin = numbersFrom(args.origin);
  if (!resolution || resolution->size() != 1)
    return wrong(
        Text::tr("--resolution %1: give metres per cell, for example 0.05.").arg(text(args.resolution)));
  if (!origin || origin->size() != 2)
    return wrong(Text::tr("--origin %1: give X,Y in metres, for example -10,-5.").arg(text(args.origin)));
  const auto map =
      jobs::newMapFrom({text(args.image), text(args.name), resolution->front(), (*origin)[0], (*origin)[1]});
  if (!map) return wrong(map.error());
  if (map->made_opaque)
    say(Text::tr("%1 has transparent pixels: they are sent as gray, which is unknown.")
            .arg(oneLine(text(args.image))));
  return addMap(command, args, map->map);
}

/// The cells of a picture as map_server reads them: from 65 % occupied, below 19.6 % free, between unknown.
struct OccupancyOfPicture {
  std::shared_ptr<const grids::GridPyramid> cells;
  qint64 between = 0;  // neither quite free nor quite occupied, and not meant to be unknown
};

OccupancyOfPicture occupancyOf(const grids::GridPyramid& picture) {
  constexpr int kOccupied = 65, kFree = 19;  // percent
  const grids::CellMeaning& meaning = grids::meaningOf(picture.code());
  std::array<std::uint8_t, 256> cell_of{};
  std::array<bool, 256> between{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    const int occupancy = meaning.occupancy[byte];
    cell_of[byte] = occupancy < 0            ? grids::kUnknownOccupancy
                    : occupancy >= kOccupied ? std::uint8_t(100)
                    : occupancy <= kFree     ? std::uint8_t(0)
                                             : grids::kUnknownOccupancy;
    between[byte] = occupancy > 0 && occupancy < 100;
  }
  const auto builder = grids::buildGrid(picture.width(), picture.height(), grids::CellCode::Occupancy,
                                        grids::Reduction::OccupiedWins);
  grids::GridRows rows(picture);
  std::vector<std::uint8_t> cells(std::size_t(picture.width()));
  OccupancyOfPicture made;
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* const row = rows.row(y);
    for (std::size_t x = 0; x < cells.size(); ++x) {
      cells[x] = cell_of[row[x]];
      made.between += between[row[x]] ? 1 : 0;
    }
    builder->pushRow(cells);
  }
  builder->finish();
  made.cells = builder->pyramid();
  return made;
}

CommandResult<int> mapsSetImage(RobotCommand& command, const TransferArguments& args) {
  const map::MapKey key = map::mapKeyFromText(args.id);
  if (key.kind != map::MapKind::Stored || !isPlainId(key.id))
    return wrong(Text::tr("%1: pass the id of a stored map (see mapwright maps list).").arg(text(args.id)));
  const auto file = command.open(RobotReading::Purpose::Maps, text(args.image));
  if (!file) return passOn(file);
  if (!(*file)->local())
    return wrong(Text::tr("%1: pass an image file (.pgm, .png) or its map.yaml.").arg(text(args.image)));
  const auto picture = (*file)->map(QString(), 0.05);
  if (!picture) return passOn(picture);
  const auto opened = command.open();
  if (!opened) return passOn(opened);
  RobotReading& reading = **opened;
  reading.await(robot::Capability::PictureEditing);
  robot::PictureStore* const store = reading.session().robot().pictureStore();
  if (!store) return reading.lacks(robot::Capability::PictureEditing);
  const auto now = reading.map(text(args.id), 0.05);
  if (!now) return passOn(now);
  const map::WholeMap& map = reading.session().wholeMap().shown();
  if (store->obstacle(map) || now->cells->code() != grids::CellCode::Occupancy)
    return reading.failure(kRobotError, Text::tr("The image of this map cannot be set from here."));
  if (picture->cells->width() != now->cells->width() || picture->cells->height() != now->cells->height())
    return wrong(Text::tr("%1 has %2 x %3 pixels, but the map has %4 x %5 cells. Nothing was sent.")
                     .arg(text(args.image))
                     .arg(picture->cells->width())
                     .arg(picture->cells->height())
                     .arg(now->cells->width())
                     .arg(now->cells->height()));
  const OccupancyOfPicture wanted = occupancyOf(*picture->cells);
  if (wanted.between > 0)
    reading.addRemark(sentences::counted(
        Text::tr("%1 cells of the image are neither free nor occupied but in between: they are sent as "
                 "map_server reads them (from 65 % occupied, below 19.6 % free, else unknown).",
                 nullptr, sentences::formOf(wanted.between)),
        wanted.between));
  const auto line = std::make_shared<ProgressLine>();
  const auto done = reading.ask<robot::PictureReceipt>([&](robot::OutcomeTo<robot::PictureReceipt> reply) {
    robot::Call call = store->write({key, wanted.cells, map.fingerprint}, std::move(reply));
    showProgress(call, line);
    return call;
  });
  line->clear();
  if (!done) return reading.failure(done.error());
  if (args.json) {
    printJson(
        QJsonObject{{QStringLiteral("id"), text(args.id)}, {QStringLiteral("between"), wanted.between}});
  } else {
    printLine(Text::tr("%1: the image was replaced, and the robot shows it.").arg(words::plainName(args.id)));
  }
  return kDone;
}

}  // namespace

void addMapTransfers(Commands& commands, CLI::App& maps) {
  const auto args = std::make_shared<TransferArguments>();
  const auto add = [&](const char* name, const QString& about, auto run) {
    CLI::App* const command =
        addReading(commands, maps, name, about, Text::tr("Robot address (or MAPWRIGHT_ROBOT)"), args, run);
    addJson(*command, args->json);
    return command;
  };
  CLI::App* const download =
      add("download",
          Text::tr("Download a stored map with its positioning data, or resume an interrupted download"),
          mapsDownload);
  download->add_option("id", args->id, help(Text::tr("Id of a stored map")))->required();
  download->add_option("-o,--output", args->folder, help(Text::tr("Folder for the files")))
      ->required()
      ->type_name("DIR");
  download->add_flag("--force", args->force, help(Text::tr("Replace the map in the folder")));
  CLI::App* const upload = add("upload", Text::tr("Add a downloaded map to the robot's maps"), mapsUpload);
  upload->add_option("folder", args->folder, help(Text::tr("Folder of a finished download")))->required();
  upload->add_option("--name", args->name, help(Text::tr("Give the map this name")));
  upload->add_flag("--as-new", args->as_new, help(Text::tr("Add it as another map, with a new uid")));
  CLI::App* const image =
      add("set-image", Text::tr("Replace the image of the robot's current map (KABAM)"), mapsSetImage);
  image->add_option("id", args->id, help(Text::tr("Id of the map")))->required();
  image
      ->add_option(
          "file", args->image,
          help(Text::tr("A PGM or PNG of the same size, or its map.yaml: black occupied, white free, "
                        "205 unknown")))
      ->required();
  CLI::App* const create = add("create", Text::tr("Add a map made from a picture"), mapsCreate);
  create->add_option("name", args->name, help(Text::tr("Name of the new map")))->required();
  create
      ->add_option("--image", args->image,
                   help(Text::tr("A PNG: black occupied, white free, gray or transparent unknown")))
      ->required();
  create->add_option("--resolution", args->resolution, help(Text::tr("Metres per pixel")))->required();
  create->add_option("--origin", args->origin, help(Text::tr("X,Y of its lower left corner in metres")))
      ->required();
}

}  // namespace mapwright::app
