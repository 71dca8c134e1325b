<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>CloudText</name>
    <message numerus="yes">
        <source>%1 points are shown.</source>
        <translation>
            <numerusform>%1 point is shown.</numerusform>
            <numerusform>%1 points are shown.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more have invalid or absurdly large coordinates and were left out.</source>
        <translation>
            <numerusform>%1 more has invalid or absurdly large coordinates and was left out.</numerusform>
            <numerusform>%1 more have invalid or absurdly large coordinates and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 points, evenly spread, are not shown, to save memory.</source>
        <translation>
            <numerusform>%1 point is not shown, to save memory.</numerusform>
            <numerusform>%1 points, evenly spread, are not shown, to save memory.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 older clouds were discarded to save memory.</source>
        <translation>
            <numerusform>%1 older cloud was discarded to save memory.</numerusform>
            <numerusform>%1 older clouds were discarded to save memory.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 points</source>
        <translation>
            <numerusform>%1 point</numerusform>
            <numerusform>%1 points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message numerus="yes">
        <source>%1 overlays of the old map have no usable coordinates and were left out.</source>
        <translation>
            <numerusform>%1 overlay of the old map has no usable coordinates and was left out.</numerusform>
            <numerusform>%1 overlays of the old map have no usable coordinates and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps lie too far away to be compared: %2.</source>
        <translation>
            <numerusform>%1 submap lies too far away to be compared: %2.</numerusform>
            <numerusform>%1 submaps lie too far away to be compared: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>… and %1 more places (--csv or --json for all)</source>
        <translation>
            <numerusform>… and %1 more place (--csv or --json for all)</numerusform>
            <numerusform>… and %1 more places (--csv or --json for all)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cells of the image are neither free nor occupied but in between: they are sent as map_server reads them (from 65 % occupied, below 19.6 % free, else unknown).</source>
        <translation>
            <numerusform>%1 cell of the image is neither free nor occupied but in between: it is sent as map_server reads it (from 65 % occupied, below 19.6 % free, else unknown).</numerusform>
            <numerusform>%1 cells of the image are neither free nor occupied but in between: they are sent as map_server reads them (from 65 % occupied, below 19.6 % free, else unknown).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cells</source>
        <translation>
            <numerusform>%1 cell</numerusform>
            <numerusform>%1 cells</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cells in its answers are outside the range of -1 to 100. Values above 100 are shown as 100, values below -1 as unknown.</source>
        <translation>
            <numerusform>%1 cell in its answers is outside the range of -1 to 100. It is shown as 100 if it is above that, else as unknown.</numerusform>
            <numerusform>%1 cells in its answers are outside the range of -1 to 100. Values above 100 are shown as 100, values below -1 as unknown.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 markers of %2 are missing: the transforms that place them had not arrived.</source>
        <translation>
            <numerusform>%1 marker of %2 is missing: the transform that places it had not arrived.</numerusform>
            <numerusform>%1 markers of %2 are missing: the transforms that place them had not arrived.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps could not be read back from the disk: parts of the picture are empty.</source>
        <translation>
            <numerusform>%1 submap could not be read back from the disk: parts of the picture are empty.</numerusform>
            <numerusform>%1 submaps could not be read back from the disk: parts of the picture are empty.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints</source>
        <translation>
            <numerusform>%1 waypoint</numerusform>
            <numerusform>%1 waypoints</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 features</source>
        <translation>
            <numerusform>%1 feature</numerusform>
            <numerusform>%1 features</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Nothing was sent: %1 conflicts with what others changed since the base.</source>
        <translation>
            <numerusform>Nothing was sent: %1 conflict with what others changed since the base.</numerusform>
            <numerusform>Nothing was sent: %1 conflicts with what others changed since the base.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 accepted pictures</source>
        <translation>
            <numerusform>%1 accepted picture</numerusform>
            <numerusform>%1 accepted pictures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ComparisonText</name>
    <message numerus="yes">
        <source>%1 pixels</source>
        <translation>
            <numerusform>%1 pixel</numerusform>
            <numerusform>%1 pixels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels differ</source>
        <translation>
            <numerusform>%1 pixel differs</numerusform>
            <numerusform>%1 pixels differ</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FactsChanges</name>
    <message numerus="yes">
        <source>%1 clusters: nothing known changed there.</source>
        <translation>
            <numerusform>%1 cluster: nothing known changed there.</numerusform>
            <numerusform>%1 clusters: nothing known changed there.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FetchCloud</name>
    <message numerus="yes">
        <source>%1 points that the robot announced did not arrive: its answer is cut off.</source>
        <translation>
            <numerusform>%1 point that the robot announced did not arrive: its answer is cut off.</numerusform>
            <numerusform>%1 points that the robot announced did not arrive: its answer is cut off.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 points lie outside the requested region and were left out.</source>
        <translation>
            <numerusform>%1 point lies outside the requested region and was left out.</numerusform>
            <numerusform>%1 points lie outside the requested region and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more points have invalid or absurdly large coordinates and were left out.</source>
        <translation>
            <numerusform>%1 more point has invalid or absurdly large coordinates and was left out.</numerusform>
            <numerusform>%1 more points have invalid or absurdly large coordinates and were left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FoundRobot</name>
    <message numerus="yes">
        <source>%1 topics</source>
        <translation>
            <numerusform>%1 topic</numerusform>
            <numerusform>%1 topics</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 services</source>
        <translation>
            <numerusform>%1 service</numerusform>
            <numerusform>%1 services</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Incident</name>
    <message numerus="yes">
        <source>%1 earlier events are left out.</source>
        <translation>
            <numerusform>%1 earlier event is left out.</numerusform>
            <numerusform>%1 earlier events are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>%1 more is not listed.</numerusform>
            <numerusform>%1 more are not listed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more topics begin only later.</source>
        <translation>
            <numerusform>%1 more topic begins only later.</numerusform>
            <numerusform>%1 more topics begin only later.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>OutcomeText</name>
    <message numerus="yes">
        <source>%1 views as expected</source>
        <translation>
            <numerusform>%1 view as expected</numerusform>
            <numerusform>%1 views as expected</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views differ</source>
        <translation>
            <numerusform>%1 view differs</numerusform>
            <numerusform>%1 views differ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views are over a limit</source>
        <translation>
            <numerusform>%1 view is over a limit</numerusform>
            <numerusform>%1 views are over a limit</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views have no expected picture</source>
        <translation>
            <numerusform>%1 view has no expected picture</numerusform>
            <numerusform>%1 views have no expected picture</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views failed</source>
        <translation>
            <numerusform>%1 view failed</numerusform>
            <numerusform>%1 views failed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>OverlayText</name>
    <message numerus="yes">
        <source>%1 points</source>
        <translation>
            <numerusform>%1 point</numerusform>
            <numerusform>%1 points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 features</source>
        <translation>
            <numerusform>%1 feature</numerusform>
            <numerusform>%1 features</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 changes</source>
        <translation>
            <numerusform>%1 change</numerusform>
            <numerusform>%1 changes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProblemLog</name>
    <message numerus="yes">
        <source>%1 older problems are no longer listed.</source>
        <translation>
            <numerusform>%1 older problem is no longer listed.</numerusform>
            <numerusform>%1 older problems are no longer listed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Quality</name>
    <message numerus="yes">
        <source>%1 cells at %2, submaps %3</source>
        <translation>
            <numerusform>%1 cell at %2, submaps %3</numerusform>
            <numerusform>%1 cells at %2, submaps %3</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SuitePage</name>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>%1 more is not listed.</numerusform>
            <numerusform>%1 more are not listed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WaypointJson</name>
    <message numerus="yes">
        <source>x and y of %1 features are not where their coordinates are. The coordinates count.</source>
        <translation>
            <numerusform>x and y of %1 feature are not where its coordinates are. The coordinates count.</numerusform>
            <numerusform>x and y of %1 features are not where their coordinates are. The coordinates count.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 nodes of a route graph were named by their ids.</source>
        <translation>
            <numerusform>%1 node of a route graph was named by its id.</numerusform>
            <numerusform>%1 nodes of a route graph were named by their ids.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 edges of a route graph were left out.</source>
        <translation>
            <numerusform>%1 edge of a route graph was left out.</numerusform>
            <numerusform>%1 edges of a route graph were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 features that are not points were left out.</source>
        <translation>
            <numerusform>%1 feature that is not a point was left out.</numerusform>
            <numerusform>%1 features that are not points were left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WaypointPlan</name>
    <message numerus="yes">
        <source>Waypoint types cannot be stored here: those of %1 waypoints are left out.</source>
        <translation>
            <numerusform>Waypoint types cannot be stored here: that of %1 waypoint is left out.</numerusform>
            <numerusform>Waypoint types cannot be stored here: those of %1 waypoints are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Every waypoint needs a heading here: %1 waypoints without one get 0°.</source>
        <translation>
            <numerusform>Every waypoint needs a heading here: %1 waypoint without one gets 0°.</numerusform>
            <numerusform>Every waypoint needs a heading here: %1 waypoints without one get 0°.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Tags cannot be stored here: those of %1 waypoints are left out.</source>
        <translation>
            <numerusform>Tags cannot be stored here: those of %1 waypoint are left out.</numerusform>
            <numerusform>Tags cannot be stored here: those of %1 waypoints are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints cannot be deleted here: %1 waypoints that should go stay.</source>
        <translation>
            <numerusform>Waypoints cannot be deleted here: %1 waypoint that should go stays.</numerusform>
            <numerusform>Waypoints cannot be deleted here: %1 waypoints that should go stay.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints are kept on pixels of %2 m here: %1 waypoints stay where they are, less than half a pixel from where they should be.</source>
        <translation>
            <numerusform>Waypoints are kept on pixels of %2 m here: %1 waypoint stays where it is, less than half a pixel from where it should be.</numerusform>
            <numerusform>Waypoints are kept on pixels of %2 m here: %1 waypoints stay where they are, less than half a pixel from where they should be.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints are not sent: the robot does not allow duplicate names</source>
        <translation>
            <numerusform>%1 waypoint is not sent: the robot does not allow duplicate names</numerusform>
            <numerusform>%1 waypoints are not sent: the robot does not allow duplicate names</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WaypointPoses</name>
    <message numerus="yes">
        <source>%1 lanes were left out.</source>
        <translation>
            <numerusform>%1 lane was left out.</numerusform>
            <numerusform>%1 lanes were left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WaypointReading</name>
    <message numerus="yes">
        <source>%1 headings in radians are more than a full turn. Are they degrees?</source>
        <translation>
            <numerusform>%1 heading in radians is more than a full turn. Is it in degrees?</numerusform>
            <numerusform>%1 headings in radians are more than a full turn. Are they degrees?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 orientations are no rotation (all zero) and were left out.</source>
        <translation>
            <numerusform>%1 orientation is no rotation (all zero) and was left out.</numerusform>
            <numerusform>%1 orientations are no rotation (all zero) and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints are tilted; only their heading was read.</source>
        <translation>
            <numerusform>%1 waypoint is tilted; only its heading was read.</numerusform>
            <numerusform>%1 waypoints are tilted; only their heading was read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The heights (z) of %1 waypoints were left out.</source>
        <translation>
            <numerusform>The height (z) of %1 waypoint was left out.</numerusform>
            <numerusform>The heights (z) of %1 waypoints were left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WaypointTable</name>
    <message numerus="yes">
        <source>%1 comment lines (#) were left out.</source>
        <translation>
            <numerusform>%1 comment line (#) was left out.</numerusform>
            <numerusform>%1 comment lines (#) were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints without a name were numbered.</source>
        <translation>
            <numerusform>%1 waypoint without a name was numbered.</numerusform>
            <numerusform>%1 waypoints without a name were numbered.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>aimdk</name>
    <message numerus="yes">
        <source>%1 more points have pixel and metre coordinates that differ.</source>
        <translation>
            <numerusform>%1 more point has pixel and metre coordinates that differ.</numerusform>
            <numerusform>%1 more points have pixel and metre coordinates that differ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 points have no metre coordinates. They are shown at their pixel coordinates.</source>
        <translation>
            <numerusform>%1 point has no metre coordinates. It is shown at its pixel coordinates.</numerusform>
            <numerusform>%1 points have no metre coordinates. They are shown at their pixel coordinates.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 paths of this map are not shown.</source>
        <translation>
            <numerusform>%1 path of this map is not shown.</numerusform>
            <numerusform>%1 paths of this map are not shown.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 regions of this map are not shown.</source>
        <translation>
            <numerusform>%1 region of this map is not shown.</numerusform>
            <numerusform>%1 regions of this map are not shown.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 maps in the robot&apos;s list have no id. They were left out.</source>
        <translation>
            <numerusform>%1 map in the robot&apos;s list has no id. It was left out.</numerusform>
            <numerusform>%1 maps in the robot&apos;s list have no id. They were left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>axbot</name>
    <message numerus="yes">
        <source>None of its %1 rows has a valid trajectory_id and submap_index. The previous list stays.</source>
        <translation>
            <numerusform>Its %1 row has no valid trajectory_id and submap_index. The previous list stays.</numerusform>
            <numerusform>None of its %1 rows has a valid trajectory_id and submap_index. The previous list stays.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The robot&apos;s answer (%1 bytes) is cut off or is not a submap.</source>
        <translation>
            <numerusform>The robot&apos;s answer (%1 byte) is cut off or is not a submap.</numerusform>
            <numerusform>The robot&apos;s answer (%1 bytes) is cut off or is not a submap.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A message of %1 bytes is not a JSON object. It was left out.</source>
        <translation>
            <numerusform>A message of %1 byte is not a JSON object. It was left out.</numerusform>
            <numerusform>A message of %1 bytes is not a JSON object. It was left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A binary message of %1 bytes is too short to be read. It was left out.</source>
        <translation>
            <numerusform>A binary message of %1 byte is too short to be read. It was left out.</numerusform>
            <numerusform>A binary message of %1 bytes is too short to be read. It was left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cells</name>
    <message numerus="yes">
        <source>%1 bytes where %2 (or %3) were expected</source>
        <translation>
            <numerusform>%1 byte where %2 (or %3) were expected</numerusform>
            <numerusform>%1 bytes where %2 (or %3) were expected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>files</name>
    <message numerus="yes">
        <source>%1 features are not points that can be read. They are not shown.</source>
        <translation>
            <numerusform>%1 feature is not a point that can be read. It is not shown.</numerusform>
            <numerusform>%1 features are not points that can be read. They are not shown.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>grids</name>
    <message numerus="yes">
        <source>Its header says %2 pixels, but %3 after %1 rows. The rest is shown as unknown.</source>
        <translation>
            <numerusform>Its header says %2 pixels, but %3 after %1 row. The rest is shown as unknown.</numerusform>
            <numerusform>Its header says %2 pixels, but %3 after %1 rows. The rest is shown as unknown.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Its header says %2 pixels, but %3 after %1 rows.</source>
        <translation>
            <numerusform>Its header says %2 pixels, but %3 after %1 row.</numerusform>
            <numerusform>Its header says %2 pixels, but %3 after %1 rows.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cells are outside the range of -1 to 100. They are shown as unknown.</source>
        <translation>
            <numerusform>%1 cell is outside the range of -1 to 100. It is shown as unknown.</numerusform>
            <numerusform>%1 cells are outside the range of -1 to 100. They are shown as unknown.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::edit::PictureEditing</name>
    <message numerus="yes">
        <source>%1 cells</source>
        <translation>
            <numerusform>%1 cell</numerusform>
            <numerusform>%1 cells</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ClosuresController</name>
    <message numerus="yes">
        <source>%1 loop closures.</source>
        <translation>
            <numerusform>%1 loop closure.</numerusform>
            <numerusform>%1 loop closures.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 contradict the finished map by more than 0.5 m.</source>
        <translation>
            <numerusform>%1 contradicts the finished map by more than 0.5 m.</numerusform>
            <numerusform>%1 contradict the finished map by more than 0.5 m.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 are not listed: their submap or node is not there.</source>
        <translation>
            <numerusform>%1 is not listed: its submap or node is not there.</numerusform>
            <numerusform>%1 are not listed: their submap or node is not there.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 are not listed: they have no valid pose.</source>
        <translation>
            <numerusform>%1 is not listed: it has no valid pose.</numerusform>
            <numerusform>%1 are not listed: they have no valid pose.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ClosuresDock</name>
    <message numerus="yes">
        <source>%1 submaps</source>
        <translation>
            <numerusform>%1 submap</numerusform>
            <numerusform>%1 submaps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 constraints</source>
        <translation>
            <numerusform>%1 constraint</numerusform>
            <numerusform>%1 constraints</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CloudsController</name>
    <message numerus="yes">
        <source>%1 points were received.</source>
        <translation>
            <numerusform>%1 point was received.</numerusform>
            <numerusform>%1 points were received.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>clouds of %1 points</source>
        <translation>
            <numerusform>a cloud of %1 point</numerusform>
            <numerusform>clouds of %1 points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CommandPalette</name>
    <message numerus="yes">
        <source>%1 more are not listed: type more of the name</source>
        <translation>
            <numerusform>%1 more is not listed: type more of the name</numerusform>
            <numerusform>%1 more are not listed: type more of the name</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::DisagreementController</name>
    <message numerus="yes">
        <source>%1 submaps are still missing.</source>
        <translation>
            <numerusform>%1 submap is still missing.</numerusform>
            <numerusform>%1 submaps are still missing.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 hidden submaps do not count.</source>
        <translation>
            <numerusform>%1 hidden submap does not count.</numerusform>
            <numerusform>%1 hidden submaps do not count.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps are too far away to count.</source>
        <translation>
            <numerusform>%1 submap is too far away to count.</numerusform>
            <numerusform>%1 submaps are too far away to count.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::DisagreementDock</name>
    <message numerus="yes">
        <source>Within %1 cells</source>
        <translation>
            <numerusform>Within %1 cell</numerusform>
            <numerusform>Within %1 cells</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::EventsDock</name>
    <message numerus="yes">
        <source>%1 events</source>
        <translation>
            <numerusform>%1 event</numerusform>
            <numerusform>%1 events</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 events copied</source>
        <translation>
            <numerusform>%1 event copied</numerusform>
            <numerusform>%1 events copied</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::FoundRobots</name>
    <message numerus="yes">
        <source>%1 ways to connect to %2</source>
        <translation>
            <numerusform>%1 way to connect to %2</numerusform>
            <numerusform>%1 ways to connect to %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::InspectorDock</name>
    <message numerus="yes">
        <source>%1 submaps are selected.</source>
        <translation>
            <numerusform>%1 submap is selected.</numerusform>
            <numerusform>%1 submaps are selected.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 slices</source>
        <translation>
            <numerusform>%1 slice</numerusform>
            <numerusform>%1 slices</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 trajectories</source>
        <translation>
            <numerusform>%1 trajectory</numerusform>
            <numerusform>%1 trajectories</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 answers</source>
        <translation>
            <numerusform>%1 answer</numerusform>
            <numerusform>%1 answers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LayersDock</name>
    <message numerus="yes">
        <source>%1 layers that this file has no data for</source>
        <translation>
            <numerusform>%1 layer that this file has no data for</numerusform>
            <numerusform>%1 layers that this file has no data for</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 layers that these files have no data for</source>
        <translation>
            <numerusform>%1 layer that these files have no data for</numerusform>
            <numerusform>%1 layers that these files have no data for</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 layers that this robot has no data for</source>
        <translation>
            <numerusform>%1 layer that this robot has no data for</numerusform>
            <numerusform>%1 layers that this robot has no data for</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LineBar</name>
    <message numerus="yes">
        <source>; %1 names are taken and left out</source>
        <translation>
            <numerusform>; %1 name is taken and left out</numerusform>
            <numerusform>; %1 names are taken and left out</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ManualWindow</name>
    <message numerus="yes">
        <source>%1 places</source>
        <translation>
            <numerusform>%1 place</numerusform>
            <numerusform>%1 places</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MapsDock</name>
    <message numerus="yes">
        <source>%1 maps</source>
        <translation>
            <numerusform>%1 map</numerusform>
            <numerusform>%1 maps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ObjectCard</name>
    <message numerus="yes">
        <source>%1 other things here: Alt+click</source>
        <translation>
            <numerusform>%1 other thing here: Alt+click</numerusform>
            <numerusform>%1 other things here: Alt+click</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ObjectsDock</name>
    <message numerus="yes">
        <source>%1 objects</source>
        <translation>
            <numerusform>%1 object</numerusform>
            <numerusform>%1 objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayFlaws</name>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>%1 more is not listed.</numerusform>
            <numerusform>%1 more are not listed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayForm</name>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>%1 more is not listed.</numerusform>
            <numerusform>%1 more are not listed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayHistoryDock</name>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>%1 more is not listed.</numerusform>
            <numerusform>%1 more are not listed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 are not marked on the map.</source>
        <translation>
            <numerusform>%1 is not marked on the map.</numerusform>
            <numerusform>%1 are not marked on the map.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayMarksDialog</name>
    <message numerus="yes">
        <source>Take over %1 marks</source>
        <translation>
            <numerusform>Take over %1 mark</numerusform>
            <numerusform>Take over %1 marks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayTeaching</name>
    <message numerus="yes">
        <source>%1 marks</source>
        <translation>
            <numerusform>%1 mark</numerusform>
            <numerusform>%1 marks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PictureDock</name>
    <message numerus="yes">
        <source>%1 specks</source>
        <translation>
            <numerusform>%1 speck</numerusform>
            <numerusform>%1 specks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PlacesModel</name>
    <message numerus="yes">
        <source>and %1 others</source>
        <translation>
            <numerusform>and %1 other</numerusform>
            <numerusform>and %1 others</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProblemsDock</name>
    <message numerus="yes">
        <source>%1 problems copied</source>
        <translation>
            <numerusform>%1 problem copied</numerusform>
            <numerusform>%1 problems copied</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProjectionsController</name>
    <message numerus="yes">
        <source>The robot has answered, but %1 projections differ from what was sent. The table shows its answer.</source>
        <translation>
            <numerusform>The robot has answered, but %1 projection differs from what was sent. The table shows its answer.</numerusform>
            <numerusform>The robot has answered, but %1 projections differ from what was sent. The table shows its answer.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProjectionsDock</name>
    <message numerus="yes">
        <source>The robot has %1 projections.</source>
        <translation>
            <numerusform>The robot has %1 projection.</numerusform>
            <numerusform>The robot has %1 projections.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RangeExportDialog</name>
    <message numerus="yes">
        <source>%1 messages</source>
        <translation>
            <numerusform>%1 message</numerusform>
            <numerusform>%1 messages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 poses</source>
        <translation>
            <numerusform>%1 pose</numerusform>
            <numerusform>%1 poses</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RecordingsDock</name>
    <message numerus="yes">
        <source>%1 recordings</source>
        <translation>
            <numerusform>%1 recording</numerusform>
            <numerusform>%1 recordings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ReferenceDock</name>
    <message numerus="yes">
        <source>%1 pairs, off by %2 (root mean square)</source>
        <translation>
            <numerusform>%1 pair, off by %2 (root mean square)</numerusform>
            <numerusform>%1 pairs, off by %2 (root mean square)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RenameDialog</name>
    <message numerus="yes">
        <source>%1 names change.</source>
        <translation>
            <numerusform>%1 name changes.</numerusform>
            <numerusform>%1 names change.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 names would not be unique.</source>
        <translation>
            <numerusform>%1 name would not be unique.</numerusform>
            <numerusform>%1 names would not be unique.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 names would be empty.</source>
        <translation>
            <numerusform>%1 name would be empty.</numerusform>
            <numerusform>%1 names would be empty.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RobotDock</name>
    <message numerus="yes">
        <source>%1 alerts</source>
        <translation>
            <numerusform>%1 alert</numerusform>
            <numerusform>%1 alerts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointReview</name>
    <message numerus="yes">
        <source>%1 requests</source>
        <translation>
            <numerusform>%1 request</numerusform>
            <numerusform>%1 requests</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::Waypoints</name>
    <message numerus="yes">
        <source>%1 waypoints</source>
        <translation>
            <numerusform>%1 waypoint</numerusform>
            <numerusform>%1 waypoints</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 changes</source>
        <translation>
            <numerusform>%1 change</numerusform>
            <numerusform>%1 changes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointsDock</name>
    <message numerus="yes">
        <source>%1 warnings</source>
        <translation>
            <numerusform>%1 warning</numerusform>
            <numerusform>%1 warnings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>recorded</name>
    <message numerus="yes">
        <source>It is damaged: after %1 messages no more of it can be read.</source>
        <translation>
            <numerusform>It is damaged: after %1 message no more of it can be read.</numerusform>
            <numerusform>It is damaged: after %1 messages no more of it can be read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 bytes of it cannot be read (from byte %2 on) and are skipped.</source>
        <translation>
            <numerusform>%1 byte of it cannot be read (at byte %2) and is skipped.</numerusform>
            <numerusform>%1 bytes of it cannot be read (from byte %2 on) and are skipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it cannot be unpacked (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>%1 chunk of it cannot be unpacked (at byte %2) and is skipped.</numerusform>
            <numerusform>%1 chunks of it cannot be unpacked (the first at byte %2) and are skipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it are corrupted (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>%1 chunk of it is corrupted (at byte %2) and is skipped.</numerusform>
            <numerusform>%1 chunks of it are corrupted (the first at byte %2) and are skipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it would need too much memory (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>%1 chunk of it would need too much memory (at byte %2) and is skipped.</numerusform>
            <numerusform>%1 chunks of it would need too much memory (the first at byte %2) and are skipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it use an unknown compression: %3 (the first at byte %2). They are skipped.</source>
        <translation>
            <numerusform>%1 chunk of it uses an unknown compression: %3 (at byte %2). It is skipped.</numerusform>
            <numerusform>%1 chunks of it use an unknown compression: %3 (the first at byte %2). They are skipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it state a wrong time range (the first at byte %2).</source>
        <translation>
            <numerusform>%1 chunk of it states a wrong time range (at byte %2).</numerusform>
            <numerusform>%1 chunks of it state a wrong time range (the first at byte %2).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 message definitions in it are too large (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>%1 message definition in it is too large (at byte %2) and is skipped.</numerusform>
            <numerusform>%1 message definitions in it are too large (the first at byte %2) and are skipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 message definitions in it cannot be read (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>%1 message definition in it cannot be read (at byte %2) and is skipped.</numerusform>
            <numerusform>%1 message definitions in it cannot be read (the first at byte %2) and are skipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 messages belong to topics that it does not describe (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>%1 message belongs to a topic that it does not describe (at byte %2) and is skipped.</numerusform>
            <numerusform>%1 messages belong to topics that it does not describe (the first at byte %2) and are skipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 topics are described twice and differently (the first at byte %2). The first description is used.</source>
        <translation>
            <numerusform>%1 topic is described twice and differently (at byte %2). The first description is used.</numerusform>
            <numerusform>%1 topics are described twice and differently (the first at byte %2). The first description is used.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 messages have no usable time and are left out.</source>
        <translation>
            <numerusform>%1 message has no usable time and is left out.</numerusform>
            <numerusform>%1 messages have no usable time and are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 messages that it counts are not in it.</source>
        <translation>
            <numerusform>%1 message that it counts is not in it.</numerusform>
            <numerusform>%1 messages that it counts are not in it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A message has %1 bytes more than its definition describes: the definition may be another one. They are not shown.</source>
        <translation>
            <numerusform>A message has %1 byte more than its definition describes: the definition may be another one. It is not shown.</numerusform>
            <numerusform>A message has %1 bytes more than its definition describes: the definition may be another one. They are not shown.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 files of it are not played: it has too many.</source>
        <translation>
            <numerusform>%1 file of it is not played: it has too many.</numerusform>
            <numerusform>%1 files of it are not played: it has too many.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Its metadata.yaml is missing or damaged, as after an interrupted recording. The %1 files in its folder are played.</source>
        <translation>
            <numerusform>Its metadata.yaml is missing or damaged, as after an interrupted recording. The %1 file in its folder is played.</numerusform>
            <numerusform>Its metadata.yaml is missing or damaged, as after an interrupted recording. The %1 files in its folder are played.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>robot</name>
    <message numerus="yes">
        <source>%1 features of its overlays cannot be read.</source>
        <translation>
            <numerusform>%1 feature of its overlays cannot be read.</numerusform>
            <numerusform>%1 features of its overlays cannot be read.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ros</name>
    <message numerus="yes">
        <source>%1 markers are meshes (%2), which are not read: spots are drawn in their places.</source>
        <translation>
            <numerusform>%1 marker is a mesh (%2), which is not read: a spot is drawn in its place.</numerusform>
            <numerusform>%1 markers are meshes (%2), which are not read: spots are drawn in their places.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 markers are of an unknown kind and are not drawn.</source>
        <translation>
            <numerusform>%1 marker is of an unknown kind and is not drawn.</numerusform>
            <numerusform>%1 markers are of an unknown kind and are not drawn.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 markers cannot be placed</source>
        <translation>
            <numerusform>%1 marker cannot be placed</numerusform>
            <numerusform>%1 markers cannot be placed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The robot accepted the picture, but shows %1 cells differently. Compare the two.</source>
        <translation>
            <numerusform>The robot accepted the picture, but shows %1 cell differently. Compare the two.</numerusform>
            <numerusform>The robot accepted the picture, but shows %1 cells differently. Compare the two.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 markers are left out or cut: they cannot be read, or there are too many.</source>
        <translation>
            <numerusform>%1 marker is left out or cut: it cannot be read, or there are too many.</numerusform>
            <numerusform>%1 markers are left out or cut: they cannot be read, or there are too many.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more waypoints were left out.</source>
        <translation>
            <numerusform>%1 more waypoint was left out.</numerusform>
            <numerusform>%1 more waypoints were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more waypoints have no direction, or a frame that is unknown.</source>
        <translation>
            <numerusform>%1 more waypoint has no direction, or a frame that is unknown.</numerusform>
            <numerusform>%1 more waypoints have no direction, or a frame that is unknown.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>submap</name>
    <message numerus="yes">
        <source>%1 submaps are listed without a valid version. They are asked for from time to time.</source>
        <translation>
            <numerusform>%1 submap is listed without a valid version. It is asked for from time to time.</numerusform>
            <numerusform>%1 submaps are listed without a valid version. They are asked for from time to time.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>window</name>
    <message numerus="yes">
        <source>%1 problems</source>
        <translation>
            <numerusform>%1 problem</numerusform>
            <numerusform>%1 problems</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps</source>
        <translation>
            <numerusform>%1 submap</numerusform>
            <numerusform>%1 submaps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Loading %1 submaps</source>
        <translation>
            <numerusform>Loading %1 submap</numerusform>
            <numerusform>Loading %1 submaps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>%1 more is not listed.</numerusform>
            <numerusform>%1 more are not listed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wire</name>
    <message numerus="yes">
        <source>%1 rows without an id were left out.</source>
        <translation>
            <numerusform>%1 row without an id was left out.</numerusform>
            <numerusform>%1 rows without an id were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 points without a position were left out.</source>
        <translation>
            <numerusform>%1 point without a position was left out.</numerusform>
            <numerusform>%1 points without a position were left out.</numerusform>
        </translation>
    </message>
</context>
</TS>
