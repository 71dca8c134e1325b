<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Absence</name>
    <message>
        <source>There are no submaps here, only whole maps.</source>
        <translation>这里没有子图，只有整张地图。</translation>
    </message>
    <message>
        <source>This robot does not list its maps.</source>
        <translation>该机器人不提供地图列表。</translation>
    </message>
    <message>
        <source>This file has no list of maps.</source>
        <translation>该文件没有地图列表。</translation>
    </message>
    <message>
        <source>This robot provides no whole map.</source>
        <translation>该机器人不提供整张地图。</translation>
    </message>
    <message>
        <source>There is no whole map in this file.</source>
        <translation>该文件中没有整张地图。</translation>
    </message>
    <message>
        <source>This robot provides no overview of its map.</source>
        <translation>该机器人不提供地图总览图。</translation>
    </message>
    <message>
        <source>There is no overview of a map in this file.</source>
        <translation>该文件中没有地图总览图。</translation>
    </message>
    <message>
        <source>This robot provides no waypoints.</source>
        <translation>该机器人不提供路径点。</translation>
    </message>
    <message>
        <source>There are no waypoints in this file.</source>
        <translation>该文件中没有路径点。</translation>
    </message>
    <message>
        <source>The waypoints of this robot are read-only.</source>
        <translation>该机器人的路径点是只读的。</translation>
    </message>
    <message>
        <source>Waypoints cannot be edited in this file.</source>
        <translation>该文件中的路径点不能编辑。</translation>
    </message>
    <message>
        <source>There is no live data here.</source>
        <translation>这里没有实时数据。</translation>
    </message>
    <message>
        <source>The maps of this robot cannot be changed from here.</source>
        <translation>无法从这里修改该机器人的地图。</translation>
    </message>
    <message>
        <source>Local maps are named after their files, and no robot uses them.</source>
        <translation>本地地图以其文件命名，不被任何机器人使用。</translation>
    </message>
    <message>
        <source>The pictures of this robot&apos;s maps are read-only.</source>
        <translation>该机器人的地图图像是只读的。</translation>
    </message>
    <message>
        <source>There is no picture in this file that can be edited.</source>
        <translation>该文件中没有可编辑的图像。</translation>
    </message>
    <message>
        <source>This robot keeps no overlays that can be edited.</source>
        <translation>该机器人没有可编辑的覆盖物。</translation>
    </message>
    <message>
        <source>There are no overlays in this file that can be edited.</source>
        <translation>该文件中没有可编辑的覆盖物。</translation>
    </message>
    <message>
        <source>This robot has no bags that can be replayed.</source>
        <translation>该机器人没有可回放的数据包。</translation>
    </message>
    <message>
        <source>There is nothing in this file that can be replayed.</source>
        <translation>该文件中没有可回放的内容。</translation>
    </message>
    <message>
        <source>This robot does not send parts of its map: no regions, no clouds, no projections.</source>
        <translation>该机器人不发送地图的局部：没有分块，没有点云，也没有投影。</translation>
    </message>
    <message>
        <source>This is a file: there is no robot to fetch from.</source>
        <translation>这是一个文件：没有可供获取数据的机器人。</translation>
    </message>
    <message>
        <source>The position of this robot cannot be set from here.</source>
        <translation>无法从这里设置该机器人的位置。</translation>
    </message>
    <message>
        <source>This is a file: there is no robot whose position could be set.</source>
        <translation>这是一个文件：没有可设置位置的机器人。</translation>
    </message>
    <message>
        <source>The maps of this robot cannot be downloaded whole, and none can be added.</source>
        <translation>该机器人的地图不能整张下载，也不能添加地图。</translation>
    </message>
    <message>
        <source>This is a file: there is no robot to download maps from.</source>
        <translation>这是一个文件：没有可供下载地图的机器人。</translation>
    </message>
    <message>
        <source>There is no pose graph here.</source>
        <translation>这里没有位姿图。</translation>
    </message>
    <message>
        <source>Read only: %1&apos;s interface offers no editing.</source>
        <translation>只读：%1 的接口不支持编辑。</translation>
    </message>
    <message>
        <source>It is not known yet whether this robot can be edited: it has not answered that question. It is asked again.</source>
        <translation>尚不知道该机器人能否编辑：它还没有应答这个问题，正在再次询问。</translation>
    </message>
    <message>
        <source>Not supported in this version yet.</source>
        <translation>此版本尚不支持。</translation>
    </message>
    <message>
        <source>Its firmware does not support this request (%1).</source>
        <translation>其固件不支持该请求（%1）。</translation>
    </message>
    <message>
        <source>Its interface does not report its pose. If a rosbridge server runs on it, add %1 to its address.</source>
        <translation>其接口不上报位姿。如果机器人上运行着 rosbridge 服务器，请在地址后加上 %1。</translation>
    </message>
    <message>
        <source>%1 is not running on it, or cannot be reached from here.</source>
        <translation>机器人上没有运行 %1，或者从这里无法访问。</translation>
    </message>
    <message>
        <source>This is a replay of %1: nothing can be changed.</source>
        <translation>这是 %1 的回放：什么都不能修改。</translation>
    </message>
    <message>
        <source>This is a local map: there is no robot, so nothing moves on it.</source>
        <translation>这是本地地图：没有机器人，因此图上没有会移动的东西。</translation>
    </message>
    <message>
        <source>This is not confirmed by the robot&apos;s maker: how maps are changed is only known from third parties. The result is read back.</source>
        <translation>未经机器人厂商确认：修改地图的方法仅来自第三方资料。修改后会读回结果。</translation>
    </message>
    <message>
        <source>This is not confirmed by the robot&apos;s maker: how waypoints are changed is only known from third parties. The result is read back.</source>
        <translation>未经机器人厂商确认：修改路径点的方法仅来自第三方资料。修改后会读回结果。</translation>
    </message>
    <message>
        <source>How maps and waypoints are changed on this robot is not confirmed by its maker: try it where nothing can go wrong.</source>
        <translation>修改该机器人的地图和路径点的方法未经厂商确认：请在不会出事的环境中尝试。</translation>
    </message>
    <message>
        <source>service /map_manager/update_map_image</source>
        <translation>服务 /map_manager/update_map_image</translation>
    </message>
    <message>
        <source>KABAM map manager (/map_manager)</source>
        <translation>KABAM 地图管理器 (/map_manager)</translation>
    </message>
    <message>
        <source>map dispatcher (REP 130: get_sub_map, get_point_map …)</source>
        <translation>地图分发器 (REP 130: get_sub_map、get_point_map…)</translation>
    </message>
</context>
<context>
    <name>Address</name>
    <message>
        <source>%1: leave the user name and password out of the address. Put the secret into its own field, --secret-file or MAPWRIGHT_SECRET.</source>
        <translation>%1：地址中不要写用户名和密码。请把密钥填入单独的字段，或使用 --secret-file 或 MAPWRIGHT_SECRET。</translation>
    </message>
    <message>
        <source>Enter a robot address, for example %1.</source>
        <translation>请输入机器人地址，例如 %1。</translation>
    </message>
    <message>
        <source>Addresses that begin with %1 are not supported by this version. Use %2.</source>
        <translation>此版本不支持以 %1 开头的地址。请使用 %2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has port %2. A port is a number from 1 to 65535.</source>
        <translation>“%1”的端口是 %2。端口应为 1 到 65535 的数字。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address. For example: %2.</source>
        <translation>“%1”不是地址。例如：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not begin with a known scheme. For example: %2.</source>
        <translation>“%1”不以已知的协议开头。例如：%2。</translation>
    </message>
    <message>
        <source>The address of an Agibot robot may only have ?tf=ws://HOST:9090 (its rosbridge) after the host.</source>
        <translation>Agibot 机器人的地址在主机之后只能有 ?tf=ws://HOST:9090（其 rosbridge）。</translation>
    </message>
    <message>
        <source>The address of an Agibot robot cannot have a # part.</source>
        <translation>Agibot 机器人的地址不能带 # 部分。</translation>
    </message>
    <message>
        <source>Agibot</source>
        <translation>Agibot</translation>
    </message>
    <message>
        <source>The address of an Autoxing robot cannot have a ? or # part.</source>
        <translation>Autoxing 机器人的地址不能带 ? 或 # 部分。</translation>
    </message>
    <message>
        <source>Autoxing</source>
        <translation>Autoxing</translation>
    </message>
    <message>
        <source>file: ns is the namespace of a robot in a recording, for example ?ns=/robot1.</source>
        <translation>file: 的 ns 是录制文件中某台机器人的命名空间，例如 ?ns=/robot1。</translation>
    </message>
    <message>
        <source>file: accepts resolution and origin (of a picture) and ns (of a recording) after the ?, but not &quot;%1&quot;.</source>
        <translation>file: 在 ? 之后可用 resolution 和 origin（用于图像）以及 ns（用于录制文件），不能用“%1”。</translation>
    </message>
    <message>
        <source>file: %1 cannot be &quot;%2&quot;. For example: ?resolution=0.05&amp;origin=-10,-7.5.</source>
        <translation>file: 的 %1 不能是“%2”。例如：?resolution=0.05&amp;origin=-10,-7.5。</translation>
    </message>
    <message>
        <source>Enter the path of a map, for example file:maps/office.yaml.</source>
        <translation>请输入地图的路径，例如 file:maps/office.yaml。</translation>
    </message>
    <message>
        <source>%1 already states where its map is: leave out the part after the ?.</source>
        <translation>%1 已经说明了其地图的位置：请去掉 ? 之后的部分。</translation>
    </message>
    <message>
        <source>The address of a map dispatcher may only have ROS names after its ?, each once: ?ns=/NAMESPACE, or %1 with the name used instead.</source>
        <translation>地图分发器的地址在 ? 之后只能有 ROS 名称，每个一次：?ns=/NAMESPACE，或者 %1 加上实际使用的名称。</translation>
    </message>
    <message>
        <source>The address of a ROS robot may only have ?ns=/NAMESPACE after the host.</source>
        <translation>ROS 机器人的地址在主机之后只能有 ?ns=/NAMESPACE。</translation>
    </message>
    <message>
        <source>The address of a ROS robot cannot have a # part.</source>
        <translation>ROS 机器人的地址不能带 # 部分。</translation>
    </message>
    <message>
        <source>ROS</source>
        <translation>ROS</translation>
    </message>
    <message>
        <source>KABAM</source>
        <translation>KABAM</translation>
    </message>
    <message>
        <source>REP 130</source>
        <translation>REP 130</translation>
    </message>
</context>
<context>
    <name>AlignmentText</name>
    <message>
        <source>Give one point that is on both maps; it decides between the candidates.</source>
        <translation>请给出一个在两张地图上都有的点，用来在候选结果中做出选择。</translation>
    </message>
    <message>
        <source>Give a second point, far from the first.</source>
        <translation>请给出第二个点，离第一个点远一些。</translation>
    </message>
    <message>
        <source>One of the maps has no walls, so there is nothing to align by.</source>
        <translation>其中一张地图没有墙，因此没有可用于对齐的东西。</translation>
    </message>
    <message>
        <source>The walls of these maps fit nowhere: they seem to be of different places.</source>
        <translation>两张地图的墙在任何位置都对不上：它们似乎来自不同的地方。</translation>
    </message>
    <message>
        <source>With that pair of points the walls fit nowhere. Check the points.</source>
        <translation>按这对点，墙在任何位置都对不上。请检查这些点。</translation>
    </message>
    <message>
        <source>In many places the walls fit a little beside: one of the maps is bent, or much was moved. Two points that are on both maps align them by hand, as well as it goes.</source>
        <translation>许多地方的墙都略有偏移：其中一张地图有弯曲变形，或者许多东西被移动过。可用两张地图上都有的两个点手动对齐，做到尽可能好。</translation>
    </message>
    <message>
        <source>With that pair of points the walls do not agree. Check the points.</source>
        <translation>按这对点，墙不一致。请检查这些点。</translation>
    </message>
    <message>
        <source>The walls do not agree well enough anywhere: the maps may be of different places. Two points that are on both maps align them by hand.</source>
        <translation>墙在任何位置都不够一致：两张地图可能来自不同的地方。可用两张地图上都有的两个点手动对齐。</translation>
    </message>
    <message>
        <source>Too little of the maps overlaps to be sure. Two points that are on both maps align them by hand.</source>
        <translation>两张地图重叠太少，无法确定。可用两张地图上都有的两个点手动对齐。</translation>
    </message>
    <message>
        <source>The maps fit in more than one way, about equally well. %1</source>
        <translation>两张地图有不止一种对齐方式，吻合程度差不多。%1</translation>
    </message>
    <message>
        <source>The maps can be moved against each other and still fit, as along a corridor. %1</source>
        <translation>两张地图可以相对移动而仍然吻合，例如沿走廊方向。%1</translation>
    </message>
    <message>
        <source>One of the maps seems to be mirrored, or they are of different places.</source>
        <translation>其中一张地图似乎是镜像的，或者两张地图来自不同的地方。</translation>
    </message>
    <message>
        <source>The pairs of points contradict each other: the distances between them are not the same on both maps.</source>
        <translation>这些点对相互矛盾：它们之间的距离在两张地图上不一样。</translation>
    </message>
    <message>
        <source>The points lie too close together to tell the turn. Give points that are some metres apart.</source>
        <translation>这些点离得太近，无法判断转角。请给出相距几米的点。</translation>
    </message>
    <message>
        <source>With these pairs of points the walls agree no better than by chance. Check the points.</source>
        <translation>按这些点对，墙的一致程度不比随机的好。请检查这些点。</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, turned by %3°</source>
        <translation>x %1 m，y %2 m，旋转 %3°</translation>
    </message>
    <message>
        <source>%1 % of the smaller map</source>
        <translation>较小地图的 %1%</translation>
    </message>
    <message>
        <source>%1 % within 10 cm, median %2 m, 95 % within %3 m, largest %4 m (%5 % compared)</source>
        <translation>%1% 在 10 cm 以内，中位数 %2 m，95% 在 %3 m 以内，最大 %4 m（比较了 %5%）</translation>
    </message>
    <message>
        <source>In %1 of %2 squares of %3 m the walls are off by more than %4 cm, most at (%5, %6) of the new map: by %7 m. Something was moved there, or a map is bent.</source>
        <translation>在 %2 个 %3 m 的方格中，有 %1 个方格的墙偏差超过 %4 cm，最大处位于新地图的 (%5, %6)：偏差 %7 m。那里有东西被移动过，或者地图有弯曲变形。</translation>
    </message>
    <message>
        <source>Not sure. %1</source>
        <translation>不确定。%1</translation>
    </message>
    <message>
        <source>%1 % of the old map&apos;s walls have a wall of the new map within 10 cm.</source>
        <translation>旧地图的墙有 %1% 在 10 cm 以内能找到新地图的墙。</translation>
    </message>
    <message>
        <source>Sure: the maps fit in one way only. %1</source>
        <translation>确定：两张地图只有一种对齐方式。%1</translation>
    </message>
    <message>
        <source>Chosen by the pair of points, which is %1 m off. %2</source>
        <translation>根据这对点选定，其偏差为 %1 m。%2</translation>
    </message>
    <message>
        <source>Aligned by the pairs of points. The maps do not overlap, so no wall confirms it.</source>
        <translation>已按这些点对对齐。两张地图没有重叠，因此没有墙可以印证。</translation>
    </message>
    <message>
        <source>Aligned by the pairs of points. %1</source>
        <translation>已按这些点对对齐。%1</translation>
    </message>
    <message>
        <source>A part lies %1 cm beside, near (%2, %3) of the new map: look there.</source>
        <translation>有一部分偏移了 %1 cm，位于新地图的 (%2, %3) 附近：请查看那里。</translation>
    </message>
    <message>
        <source>It is about right, but the walls that both maps show do not hold it to 5 cm and 0.3 degrees. Two points that are on both maps align them by hand.</source>
        <translation>位置大致正确，但两张地图都能看到的墙不足以将其确定到 5 cm 和 0.3 度以内。可用两张地图上都有的两个点手动对齐。</translation>
    </message>
    <message>
        <source>The walls agree, but almost no furniture does: it may be another floor of the same shape. If you know that it is not, give one point that is on both maps.</source>
        <translation>墙是一致的，但几乎没有一件家具一致：可能是形状相同的另一楼层。如果您知道不是，请给出一个在两张地图上都有的点。</translation>
    </message>
    <message>
        <source>Of %1 pieces of furniture %2 stand where they stood: much was moved, or it is another floor of the same shape.</source>
        <translation>%1 件家具中有 %2 件还在原处：许多东西被移动过，或者这是形状相同的另一楼层。</translation>
    </message>
</context>
<context>
    <name>CarryText</name>
    <message>
        <source>kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>adjusted</source>
        <translation>已调整</translation>
    </message>
    <message>
        <source>in an obstacle</source>
        <translation>在障碍物中</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>在地图外</translation>
    </message>
    <message>
        <source>unreachable</source>
        <translation>不可达</translation>
    </message>
    <message>
        <source>not supported</source>
        <translation>不支持</translation>
    </message>
    <message>
        <source>Moved by the transform alone.</source>
        <translation>仅按变换移动。</translation>
    </message>
    <message>
        <source>Moved a little further, to where the walls around it are now.</source>
        <translation>又略微移动，使其与现在周围的墙相符。</translation>
    </message>
    <message>
        <source>A wall is there now, or so close that the robot does not fit.</source>
        <translation>那里现在有墙，或者离墙太近，机器人放不下。</translation>
    </message>
    <message>
        <source>The new map knows nothing there.</source>
        <translation>新地图在那里没有任何信息。</translation>
    </message>
    <message>
        <source>It is cut off: the robot cannot drive there.</source>
        <translation>它被隔断了：机器人开不到那里。</translation>
    </message>
    <message>
        <source>No wall around it agrees, so its place is a guess.</source>
        <translation>周围没有一致的墙，所以其位置是推测的。</translation>
    </message>
</context>
<context>
    <name>ChangeMap</name>
    <message>
        <source>A map must have a name.</source>
        <translation>地图必须有名称。</translation>
    </message>
    <message>
        <source>The name of a map must be one line without control characters.</source>
        <translation>地图名称必须是一行，且不含控制字符。</translation>
    </message>
    <message>
        <source>Another map has this name: id %1.</source>
        <translation>另一张地图已使用该名称：id %1。</translation>
    </message>
    <message>
        <source>Other maps have this name: ids %1 and others.</source>
        <translation>其他地图已使用该名称：id %1 等。</translation>
    </message>
    <message>
        <source>Other maps have this name: ids %1.</source>
        <translation>其他地图已使用该名称：id %1。</translation>
    </message>
    <message>
        <source>The name of the file must be one line, such as office.png.</source>
        <translation>文件名必须是一行，例如 office.png。</translation>
    </message>
    <message>
        <source>The robot accepted the change, but says that the map is called &quot;%1&quot;.</source>
        <translation>机器人接受了更改，但报告地图名称为“%1”。</translation>
    </message>
    <message>
        <source>The robot accepted the change, but still uses another map.</source>
        <translation>机器人接受了更改，但仍在使用另一张地图。</translation>
    </message>
    <message>
        <source>The robot accepted the change, but does not list the map as archived.</source>
        <translation>机器人接受了更改，但没有将该地图列为已归档。</translation>
    </message>
    <message>
        <source>The robot accepted the change, but still lists the map as archived.</source>
        <translation>机器人接受了更改，但仍将该地图列为已归档。</translation>
    </message>
</context>
<context>
    <name>ChangeOverlays</name>
    <message>
        <source>The overlays were sent, but what the robot holds now cannot be read. %1</source>
        <translation>覆盖物已下发，但无法读取机器人现在的内容。%1</translation>
    </message>
    <message>
        <source>Someone else changed the overlays while they were being saved (version %1, then %2).</source>
        <translation>保存期间覆盖物被他人修改过（先是版本 %1，后是 %2）。</translation>
    </message>
    <message>
        <source>Their changes were overwritten.</source>
        <translation>他人的更改已被覆盖。</translation>
    </message>
    <message>
        <source>The robot does not count versions of its overlays, so someone else may have changed them at the same time.</source>
        <translation>该机器人不为覆盖物记录版本号，因此同一时间可能有他人做过修改。</translation>
    </message>
    <message>
        <source>The robot has something other than what was sent (%1).</source>
        <translation>机器人上的内容与下发的不同（%1）。</translation>
    </message>
    <message>
        <source>It has not counted a change yet and may still make it. Check again in a moment.</source>
        <translation>机器人还没有计入更改，可能稍后才会生效。请过一会儿再检查。</translation>
    </message>
</context>
<context>
    <name>CloudText</name>
    <message>
        <source>Nothing has been fetched yet.</source>
        <translation>尚未获取任何内容。</translation>
    </message>
    <message numerus="yes">
        <source>%1 points are shown.</source>
        <translation>
            <numerusform>显示了 %1 个点。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 points of %2 are shown.</source>
        <translation>显示了 %2 个点中的 %1 个。</translation>
    </message>
    <message numerus="yes">
        <source>%1 more have invalid or absurdly large coordinates and were left out.</source>
        <translation>
            <numerusform>另有 %1 个点的坐标无效或大得离谱，已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 points, evenly spread, are not shown, to save memory.</source>
        <translation>
            <numerusform>为节省内存，均匀略去 %1 个点不显示。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 older clouds were discarded to save memory.</source>
        <translation>
            <numerusform>为节省内存，已丢弃 %1 个较旧的点云。</numerusform>
        </translation>
    </message>
    <message>
        <source>Some points have no height: they are drawn at 0 m.</source>
        <translation>部分点没有高度：绘制在 0 m 处。</translation>
    </message>
    <message>
        <source>The cell size appears to be %1 m.</source>
        <translation>栅格大小似乎为 %1 m。</translation>
    </message>
    <message>
        <source>The cell size cannot be determined from the positions of the cells.</source>
        <translation>无法从栅格的位置判断栅格大小。</translation>
    </message>
    <message>
        <source>They are in different frames (%1) and may not align.</source>
        <translation>它们在不同的坐标系中（%1），可能对不齐。</translation>
    </message>
    <message>
        <source>%1 of memory</source>
        <translation>内存 %1</translation>
    </message>
    <message>
        <source>There are no points in the strip.</source>
        <translation>条带中没有点。</translation>
    </message>
    <message numerus="yes">
        <source>%1 points</source>
        <translation>
            <numerusform>%1 个点</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, from %2 m to %3 m</source>
        <translation>%1，从 %2 m 到 %3 m</translation>
    </message>
    <message>
        <source>%1; one in %2 is drawn</source>
        <translation>%1；每 %2 个绘制一个</translation>
    </message>
    <message>
        <source>along %1 m, height %2 m</source>
        <translation>沿线 %1 m，高度 %2 m</translation>
    </message>
    <message>
        <source>%1; point at %2 m, %3 m</source>
        <translation>%1；点位于 %2 m，%3 m</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>%1: the name must end in one of %2, or pass --format.</source>
        <translation>%1：文件名必须以 %2 之一结尾，或者使用 --format。</translation>
    </message>
    <message>
        <source>--format %1: must be one of %2.</source>
        <translation>--format %1：必须是 %2 之一。</translation>
    </message>
    <message>
        <source>%1 messages, %2 from before the range</source>
        <translation>%1 条消息，其中 %2 条在范围之前</translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation>%1 条消息</translation>
    </message>
    <message>
        <source>%1 samples in %2 segments</source>
        <translation>%1 个采样，共 %2 段</translation>
    </message>
    <message>
        <source>An MCAP file must be a regular file (-o FILE).</source>
        <translation>MCAP 文件必须是普通文件 (-o FILE)。</translation>
    </message>
    <message>
        <source>No position of the robot was found.</source>
        <translation>未找到机器人的位置。</translation>
    </message>
    <message>
        <source>%1 is not a recording on this computer. Pass a file (.mcap, .bag, .db3).</source>
        <translation>%1 不是本机上的录制文件。请给出一个文件（.mcap、.bag、.db3）。</translation>
    </message>
    <message>
        <source>messages: %1, files: %2</source>
        <translation>消息：%1，文件：%2</translation>
    </message>
    <message>
        <source>--every must be greater than 0 seconds.</source>
        <translation>--every 必须大于 0 秒。</translation>
    </message>
    <message>
        <source>-o %1: the parts need a number in their name, for example part-%03d.mcap.</source>
        <translation>-o %1：各部分的文件名中需要有编号，例如 part-%03d.mcap。</translation>
    </message>
    <message>
        <source>It contains no messages.</source>
        <translation>其中没有消息。</translation>
    </message>
    <message>
        <source>That would be more than %1 parts. Choose a longer --every.</source>
        <translation>这样会超过 %1 个部分。请使用更长的 --every。</translation>
    </message>
    <message>
        <source>-o %1: a film must be a file (.mp4, .mkv or .webm), and its pictures are several files, for example frames/%05d.png.</source>
        <translation>-o %1：影片必须是文件（.mp4、.mkv 或 .webm），而图像是多个文件，例如 frames/%05d.png。</translation>
    </message>
    <message>
        <source>-o %1: number the pictures, for example frames/%05d.png, or name a video: .mp4, .mkv or .webm.</source>
        <translation>-o %1：请给图像编号，例如 frames/%05d.png，或者指定视频：.mp4、.mkv 或 .webm。</translation>
    </message>
    <message>
        <source>Making a video needs ffmpeg, which is not installed. Pictures work without it: -o frames/%05d.png.</source>
        <translation>制作视频需要 ffmpeg，但未安装。不用它也可以输出图像：-o frames/%05d.png。</translation>
    </message>
    <message>
        <source>There is not enough disk space for the frames of the video: %1</source>
        <translation>磁盘空间不足以存放视频的帧：%1</translation>
    </message>
    <message>
        <source>%1: ffmpeg failed. %2</source>
        <translation>%1：ffmpeg 失败。%2</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>--to is earlier than --from.</source>
        <translation>--to 早于 --from。</translation>
    </message>
    <message>
        <source>That would be more than %1 pictures. Choose a longer --every.</source>
        <translation>这样会超过 %1 张图像。请使用更长的 --every。</translation>
    </message>
    <message>
        <source>--fps must be greater than 0 and at most %1.</source>
        <translation>--fps 必须大于 0 且不超过 %1。</translation>
    </message>
    <message>
        <source>%1 of %2 pictures</source>
        <translation>第 %1 张图像，共 %2 张</translation>
    </message>
    <message>
        <source>%1: %2 pictures</source>
        <translation>%1：%2 张图像</translation>
    </message>
    <message>
        <source>%1 of %2 pictures are incomplete. %3</source>
        <translation>%2 张图像中有 %1 张不完整。%3</translation>
    </message>
    <message>
        <source>Draw the state of a bag at a given time to a PNG</source>
        <translation>将数据包在给定时刻的状态绘制为 PNG</translation>
    </message>
    <message>
        <source>Name of the bag (see mapwright bags list), or a file; FILE?ns=/NAMESPACE is one robot of several</source>
        <translation>数据包的名称（见 mapwright bags list），或者文件；FILE?ns=/NAMESPACE 表示多台机器人中的一台</translation>
    </message>
    <message>
        <source>Draw a bag at regular times, to PNG files or a video</source>
        <translation>按固定间隔绘制数据包，输出 PNG 文件或视频</translation>
    </message>
    <message>
        <source>Seconds of the recording between two pictures</source>
        <translation>两张图像之间在录制文件中相隔的秒数</translation>
    </message>
    <message>
        <source>Frames per second of the video</source>
        <translation>视频的每秒帧数</translation>
    </message>
    <message>
        <source>The pictures, numbered: frames/%05d.png; or a video: .mp4, .mkv or .webm</source>
        <translation>带编号的图像：frames/%05d.png；或者视频：.mp4、.mkv 或 .webm</translation>
    </message>
    <message>
        <source>MESSAGES</source>
        <translation>消息数</translation>
    </message>
    <message>
        <source>HZ</source>
        <translation>HZ</translation>
    </message>
    <message>
        <source>ENCODING</source>
        <translation>编码</translation>
    </message>
    <message>
        <source>TOPIC</source>
        <translation>话题</translation>
    </message>
    <message>
        <source>TYPE</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>end</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>written by</source>
        <translation>写入程序</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>compression</source>
        <translation>压缩</translation>
    </message>
    <message>
        <source>%1, chunks: %2, %3 of %4</source>
        <translation>%1，数据块：%2，%3（解压后 %4）</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>no message was written</source>
        <translation>没有写入消息</translation>
    </message>
    <message>
        <source>repaired</source>
        <translation>已修复</translation>
    </message>
    <message>
        <source>cut off at %1</source>
        <translation>在 %1 处截断</translation>
    </message>
    <message>
        <source>cut off before any message was written</source>
        <translation>在写入任何消息之前截断</translation>
    </message>
    <message>
        <source>no connection</source>
        <translation>无连接</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>末尾</translation>
    </message>
    <message>
        <source>at</source>
        <translation>时刻</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>自 %1</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>%1, %2, %3 rad</source>
        <translation>%1, %2, %3 rad</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>alert</source>
        <translation>告警</translation>
    </message>
    <message>
        <source>SLAM</source>
        <translation>SLAM</translation>
    </message>
    <message>
        <source>planner</source>
        <translation>规划器</translation>
    </message>
    <message>
        <source>jack</source>
        <translation>顶升</translation>
    </message>
    <message>
        <source>towing</source>
        <translation>牵引</translation>
    </message>
    <message>
        <source>map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>submaps</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>A time of the recording: 2024-06-03T09:00:00Z or seconds since 1970; 09:00:00 (UTC) of its day; +90 or +1:30 after its start; -10 before its end</source>
        <translation>录制文件中的时间：2024-06-03T09:00:00Z 或 1970 年起的秒数；09:00:00 (UTC) 为当天时间；+90 或 +1:30 为开始之后；-10 为结束之前</translation>
    </message>
    <message>
        <source>%1 is not a time: give 2024-06-03T09:00:00Z, 09:00:00, +1:30, -10 or seconds since 1970</source>
        <translation>%1 不是时间：请给出 2024-06-03T09:00:00Z、09:00:00、+1:30、-10 或 1970 年起的秒数</translation>
    </message>
    <message>
        <source>%1 %2 is not within the recording: it lasts from %3 to %4 UTC.</source>
        <translation>%1 %2 不在录制文件的范围内：该文件从 %3 到 %4 UTC。</translation>
    </message>
    <message>
        <source>No message was found.</source>
        <translation>未找到消息。</translation>
    </message>
    <message>
        <source>No message of %1 was found.</source>
        <translation>未找到 %1 的消息。</translation>
    </message>
    <message>
        <source>Messages left out because they have no time stamp or cannot be read: %1.</source>
        <translation>因没有时间戳或无法读取而略去的消息：%1。</translation>
    </message>
    <message>
        <source>Which robot? Pass --robot ADDRESS or set MAPWRIGHT_ROBOT; demo: is the built-in simulated robot.</source>
        <translation>哪台机器人？请使用 --robot ADDRESS 或设置 MAPWRIGHT_ROBOT；demo: 是内置的模拟机器人。</translation>
    </message>
    <message>
        <source>--against %1 is not a recording. Pass a file (.mcap, .bag, .db3) or the name of a bag of the robot.</source>
        <translation>--against %1 不是录制文件。请给出一个文件（.mcap、.bag、.db3）或机器人上数据包的名称。</translation>
    </message>
    <message>
        <source>--against %1: there is no such file.</source>
        <translation>--against %1：没有这个文件。</translation>
    </message>
    <message>
        <source>%1 % read</source>
        <translation>已读取 %1%</translation>
    </message>
    <message>
        <source>%1: %2 at %3</source>
        <translation>%1：%2，时刻 %3</translation>
    </message>
    <message>
        <source>, beside %1 at %2</source>
        <translation>，对照 %1，时刻 %2</translation>
    </message>
    <message>
        <source>, %1 m away</source>
        <translation>，相距 %1 m</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>录制文件</translation>
    </message>
    <message>
        <source>bag</source>
        <translation>数据包</translation>
    </message>
    <message>
        <source>There are no bags.</source>
        <translation>没有数据包。</translation>
    </message>
    <message>
        <source>KIND</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>SIZE</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>END (UTC)</source>
        <translation>结束 (UTC)</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Where should it be saved? Pass -o FILE.</source>
        <translation>保存到哪里？请使用 -o FILE。</translation>
    </message>
    <message>
        <source>A download can be resumed, so it must go to a regular file (-o FILE).</source>
        <translation>下载可以续传，因此必须保存到普通文件 (-o FILE)。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Deleting a bag cannot be undone. Pass --yes to delete %1.</source>
        <translation>删除数据包后无法撤销。要删除 %1，请使用 --yes。</translation>
    </message>
    <message>
        <source>--kind: &quot;%1&quot; is unknown. Choose from: alerts, planner, position, maps, stops.</source>
        <translation>--kind：未知的“%1”。可选：alerts、planner、position、maps、stops。</translation>
    </message>
    <message>
        <source>Nothing happened.</source>
        <translation>没有发生任何事件。</translation>
    </message>
    <message>
        <source>List the bags and recordings of a robot</source>
        <translation>列出机器人的数据包和录制文件</translation>
    </message>
    <message>
        <source>Show the times and topics, with their counts and mean rates</source>
        <translation>显示时间和话题，以及消息数和平均频率</translation>
    </message>
    <message>
        <source>Print the messages as recorded, one per line</source>
        <translation>按录制内容输出消息，每行一条</translation>
    </message>
    <message>
        <source>Show the state at a given time</source>
        <translation>显示给定时刻的状态</translation>
    </message>
    <message>
        <source>List alerts, planner states, position jumps, map changes and lost localization</source>
        <translation>列出告警、规划器状态、位置跳变、地图更换和定位丢失</translation>
    </message>
    <message>
        <source>Write an HTML report of what the robot believed at a given time</source>
        <translation>生成 HTML 报告，说明机器人在给定时刻的判断</translation>
    </message>
    <message>
        <source>Download a bag, or resume an interrupted download</source>
        <translation>下载数据包，或续传中断的下载</translation>
    </message>
    <message>
        <source>Export a part as MCAP or JSON lines</source>
        <translation>将一部分导出为 MCAP 或 JSON 行</translation>
    </message>
    <message>
        <source>Export the robot&apos;s path as CSV, GeoJSON or TUM</source>
        <translation>将机器人的路径导出为 CSV、GeoJSON 或 TUM</translation>
    </message>
    <message>
        <source>Recover what is intact in an interrupted or damaged recording and write it as a complete MCAP file</source>
        <translation>恢复中断或损坏的录制文件中完好的内容，写成完整的 MCAP 文件</translation>
    </message>
    <message>
        <source>Split a recording into parts of equal length that can each be replayed alone</source>
        <translation>将录制文件拆分为等长的部分，每部分可单独回放</translation>
    </message>
    <message>
        <source>Merge several recordings into one</source>
        <translation>将多个录制文件合并为一个</translation>
    </message>
    <message>
        <source>Delete a bag from the robot (--yes)</source>
        <translation>从机器人上删除数据包 (--yes)</translation>
    </message>
    <message>
        <source>Make the robot record a bag</source>
        <translation>让机器人录制数据包</translation>
    </message>
    <message>
        <source>Recordings on this computer</source>
        <translation>本机上的录制文件</translation>
    </message>
    <message>
        <source>Only messages of this topic; separate several with commas</source>
        <translation>只要该话题的消息；多个话题用逗号分隔</translation>
    </message>
    <message>
        <source>Output file; - is the standard output</source>
        <translation>输出文件；- 表示标准输出</translation>
    </message>
    <message>
        <source>mcap or jsonl; by default taken from the file name</source>
        <translation>mcap 或 jsonl；默认由文件名决定</translation>
    </message>
    <message>
        <source>csv, geojson or tum; by default taken from the file name</source>
        <translation>csv、geojson 或 tum；默认由文件名决定</translation>
    </message>
    <message>
        <source>Names of the MCAP files, with a number: part-%03d.mcap</source>
        <translation>MCAP 文件的名称，带编号：part-%03d.mcap</translation>
    </message>
    <message>
        <source>The MCAP file to write</source>
        <translation>要写入的 MCAP 文件</translation>
    </message>
    <message>
        <source>Length of each part in seconds</source>
        <translation>每部分的时长（秒）</translation>
    </message>
    <message>
        <source>Only these kinds, separated by commas: alerts, planner, position, maps, stops</source>
        <translation>只要这些类别，用逗号分隔：alerts、planner、position、maps、stops</translation>
    </message>
    <message>
        <source>Show another run beside it: OTHER@TIME, or OTHER for when it was nearest to the same place</source>
        <translation>同时显示另一次运行作为对照：OTHER@TIME，或仅 OTHER，即取其离同一地点最近的时刻</translation>
    </message>
    <message>
        <source>The HTML file; - is the standard output</source>
        <translation>HTML 文件；- 表示标准输出</translation>
    </message>
    <message>
        <source>Output file; by default named after the bag</source>
        <translation>输出文件；默认以数据包命名</translation>
    </message>
    <message>
        <source>Required: deleting cannot be undone</source>
        <translation>必需：删除后无法撤销</translation>
    </message>
    <message>
        <source>Part of the bag&apos;s name</source>
        <translation>数据包名称的一部分</translation>
    </message>
    <message>
        <source>For example 90s or 2m</source>
        <translation>例如 90s 或 2m</translation>
    </message>
    <message>
        <source>What to record, in the robot&apos;s own terms, for example pos</source>
        <translation>要录制的内容，用机器人自己的说法，例如 pos</translation>
    </message>
    <message>
        <source>Bags and recordings of a robot: list, inspect, download, record</source>
        <translation>机器人的数据包 (bag) 和录制文件：列出、查看、下载、录制</translation>
    </message>
    <message>
        <source>Robot address (or MAPWRIGHT_ROBOT)</source>
        <translation>机器人地址（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>Nothing was carried over. %1</source>
        <translation>没有迁移任何内容。%1</translation>
    </message>
    <message>
        <source>on the new map already</source>
        <translation>新地图上已有</translation>
    </message>
    <message>
        <source>left out: what belongs to it is on the new map already</source>
        <translation>略去：与其相关的内容已在新地图上</translation>
    </message>
    <message>
        <source> (together with %1)</source>
        <translation> （连同 %1）</translation>
    </message>
    <message>
        <source>BECAME</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>X (m)</source>
        <translation>X (m)</translation>
    </message>
    <message>
        <source>Y (m)</source>
        <translation>Y (m)</translation>
    </message>
    <message>
        <source>YAW (°)</source>
        <translation>朝向 (°)</translation>
    </message>
    <message>
        <source>WALLS OFF (m)</source>
        <translation>墙偏差 (m)</translation>
    </message>
    <message>
        <source>%1 carried over</source>
        <translation>迁移了 %1</translation>
    </message>
    <message>
        <source>%1 on the new map already</source>
        <translation>新地图上已有 %1</translation>
    </message>
    <message>
        <source>%1 left out (%2)</source>
        <translation>略去 %1（%2）</translation>
    </message>
    <message>
        <source>Old map</source>
        <translation>旧地图</translation>
    </message>
    <message>
        <source>New map</source>
        <translation>新地图</translation>
    </message>
    <message>
        <source>Old to new</source>
        <translation>旧到新</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Given by hand.</source>
        <translation>手动给出。</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>What became of each</source>
        <translation>各项的结果</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Became</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>x (m)</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y (m)</source>
        <translation>y (m)</translation>
    </message>
    <message>
        <source>Yaw (°)</source>
        <translation>朝向 (°)</translation>
    </message>
    <message>
        <source>Walls off (m)</source>
        <translation>墙偏差 (m)</translation>
    </message>
    <message>
        <source>What the words mean</source>
        <translation>用词说明</translation>
    </message>
    <message>
        <source>Pass -o F.geojson to write what is carried over, or --dry-run to look only.</source>
        <translation>要写出迁移的内容，请使用 -o F.geojson；只想查看，请使用 --dry-run。</translation>
    </message>
    <message>
        <source>--output %1: what is written is GeoJSON. Name it NAME.geojson.</source>
        <translation>--output %1：写出的是 GeoJSON。请命名为 NAME.geojson。</translation>
    </message>
    <message>
        <source>Pass either -o or --dry-run.</source>
        <translation>-o 和 --dry-run 只能使用其一。</translation>
    </message>
    <message>
        <source>Waypoints carried over</source>
        <translation>迁移的路径点</translation>
    </message>
    <message>
        <source>Its overlays cannot be read. %1</source>
        <translation>无法读取其覆盖物。%1</translation>
    </message>
    <message numerus="yes">
        <source>%1 overlays of the old map have no usable coordinates and were left out.</source>
        <translation>
            <numerusform>旧地图的 %1 个覆盖物没有可用的坐标，已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>Overlays carried over</source>
        <translation>迁移的覆盖物</translation>
    </message>
    <message>
        <source>Bring the waypoints of an old map of a site to a new one</source>
        <translation>将现场旧地图的路径点迁移到新地图</translation>
    </message>
    <message>
        <source>Bring the overlays of an old map of a site to a new one</source>
        <translation>将现场旧地图的覆盖物迁移到新地图</translation>
    </message>
    <message>
        <source>Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)</source>
        <translation>机器人地址、map.yaml、图像或文件夹（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>The old map: a map of --robot, a file or address, or ID@ADDRESS</source>
        <translation>旧地图：--robot 的某张地图、文件或地址，或 ID@ADDRESS</translation>
    </message>
    <message>
        <source>The same for the new map</source>
        <translation>新地图，写法相同</translation>
    </message>
    <message>
        <source>X,Y:X,Y: a point of the old map and the same point of the new one</source>
        <translation>X,Y:X,Y：旧地图上的一个点和新地图上的同一个点</translation>
    </message>
    <message>
        <source>Move each a little further, to where the walls around it are now</source>
        <translation>把每一项再略微移动，使其与现在周围的墙相符</translation>
    </message>
    <message>
        <source>Write the waypoints, for waypoints import; - is the standard output</source>
        <translation>写出路径点，供 waypoints import 使用；- 表示标准输出</translation>
    </message>
    <message>
        <source>Write the overlays of the new map with those that are carried over, for overlays set; - is the standard output</source>
        <translation>写出新地图的覆盖物，连同迁移过来的，供 overlays set 使用；- 表示标准输出</translation>
    </message>
    <message>
        <source>Write a report: a page for people if it ends in .html, else JSON with all warnings</source>
        <translation>写出报告：以 .html 结尾时为供人阅读的网页，否则为包含所有警告的 JSON</translation>
    </message>
    <message>
        <source>Also carry over what is not sound</source>
        <translation>有问题的也一并迁移</translation>
    </message>
    <message>
        <source>Only say what would become of each</source>
        <translation>只说明各项会有什么结果</translation>
    </message>
    <message>
        <source>Lower left corner of a plain picture file: X,Y or X,Y,YAW</source>
        <translation>纯图像文件的左下角：X,Y 或 X,Y,YAW</translation>
    </message>
    <message>
        <source>-o must name a file that ends in .pcd, .ply or .csv.</source>
        <translation>-o 必须是以 .pcd、.ply 或 .csv 结尾的文件。</translation>
    </message>
    <message>
        <source>--ascii applies only to PCD files.</source>
        <translation>--ascii 只适用于 PCD 文件。</translation>
    </message>
    <message>
        <source>The robot answered with another region: none of the points lies in the requested one. Nothing was written.</source>
        <translation>机器人应答的是另一个区域：没有任何点位于所请求的区域内。未写入任何内容。</translation>
    </message>
    <message>
        <source>The time ran out before the file was written.</source>
        <translation>文件写完之前已超时。</translation>
    </message>
    <message>
        <source>Which part? Pass --box or --sphere, or --all for the whole map (its size is not known in advance).</source>
        <translation>哪一部分？请使用 --box 或 --sphere，或者用 --all 获取整张地图（其大小无法预知）。</translation>
    </message>
    <message>
        <source>--box is X,Y,Z,LX,LY,LZ: its centre and the lengths of its sides (greater than 0), in metres.</source>
        <translation>--box 是 X,Y,Z,LX,LY,LZ：中心和各边的长度（大于 0），单位为米。</translation>
    </message>
    <message>
        <source>--sphere is X,Y,Z,R: its centre and its radius (greater than 0), in metres.</source>
        <translation>--sphere 是 X,Y,Z,R：球心和半径（大于 0），单位为米。</translation>
    </message>
    <message>
        <source>The robot&apos;s 3D map as points: export</source>
        <translation>机器人的 3D 地图（点）：导出</translation>
    </message>
    <message>
        <source>Write the points of a region or of the whole map to a PCD, PLY or CSV file</source>
        <translation>将某个区域或整张地图的点写入 PCD、PLY 或 CSV 文件</translation>
    </message>
    <message>
        <source>Robot address, for example rep130+ws://HOST:9090 (or MAPWRIGHT_ROBOT)</source>
        <translation>机器人地址，例如 rep130+ws://HOST:9090（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>X,Y,Z,LX,LY,LZ: the centre of a box and the lengths of its sides, in metres</source>
        <translation>X,Y,Z,LX,LY,LZ：长方体的中心和各边的长度，单位为米</translation>
    </message>
    <message>
        <source>X,Y,Z,R: the centre of a sphere and its radius, in metres</source>
        <translation>X,Y,Z,R：球心和半径，单位为米</translation>
    </message>
    <message>
        <source>The whole map, regardless of its size</source>
        <translation>整张地图，无论多大</translation>
    </message>
    <message>
        <source>The centres of occupied cells instead of measured points</source>
        <translation>占据栅格的中心，而不是测得的点</translation>
    </message>
    <message>
        <source>Output file: .pcd, .ply or .csv</source>
        <translation>输出文件：.pcd、.ply 或 .csv</translation>
    </message>
    <message>
        <source>Write the PCD file as text</source>
        <translation>以文本形式写 PCD 文件</translation>
    </message>
    <message>
        <source>Print a summary on standard output</source>
        <translation>在标准输出上输出摘要</translation>
    </message>
    <message>
        <source>The benchmarks are a separate program that is built on demand, and there is no %1. Run &quot;./run bench&quot; in mapwright&apos;s source tree.</source>
        <translation>基准测试是按需构建的单独程序，但没有 %1。请在 mapwright 的源代码目录中运行“./run bench”。</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2.</source>
        <translation>无法启动 %1：%2。</translation>
    </message>
    <message>
        <source>The window layout cannot be saved: %1 is not writable.</source>
        <translation>无法保存窗口布局：%1 不可写。</translation>
    </message>
    <message>
        <source>There is no display to open the window on. mapwright snapshot works without one.</source>
        <translation>没有可打开窗口的显示器。mapwright snapshot 不需要显示器。</translation>
    </message>
    <message>
        <source>There is no display to open the window on. Rendering %1 instead.</source>
        <translation>没有可打开窗口的显示器。改为绘制 %1。</translation>
    </message>
    <message>
        <source>mapwright: view and edit the maps of mobile robots. Without a subcommand it opens the window.</source>
        <translation>mapwright：查看和编辑移动机器人的地图。不带子命令时打开窗口。</translation>
    </message>
    <message>
        <source>Help for all subcommands</source>
        <translation>所有子命令的帮助</translation>
    </message>
    <message>
        <source>Connect the window to this robot, for example axbot+http://192.168.25.25:8090; aimdk+http://HOST?tf=ws://HOST:9090 names an Agibot robot and the rosbridge that provides its pose</source>
        <translation>让窗口连接到该机器人，例如 axbot+http://192.168.25.25:8090；aimdk+http://HOST?tf=ws://HOST:9090 指定 Agibot 机器人和提供其位姿的 rosbridge</translation>
    </message>
    <message>
        <source>Open the window with a simulated robot</source>
        <translation>打开带有模拟机器人的窗口</translation>
    </message>
    <message>
        <source>For example scene=warehouse&amp;submaps=500&amp;seed=3</source>
        <translation>例如 scene=warehouse&amp;submaps=500&amp;seed=3</translation>
    </message>
    <message>
        <source>A map, a state file (.pbstream) or a recording (MCAP or ROS bag) to open</source>
        <translation>要打开的地图、状态文件 (.pbstream) 或录制文件（MCAP 或 ROS bag）</translation>
    </message>
    <message>
        <source>Open the window with a recording</source>
        <translation>打开窗口并载入录制文件</translation>
    </message>
    <message>
        <source>MCAP or ROS bag</source>
        <translation>MCAP 或 ROS bag</translation>
    </message>
    <message>
        <source>Run the benchmarks</source>
        <translation>运行基准测试</translation>
    </message>
    <message>
        <source>Everything after bench goes to Google Benchmark, for example --benchmark_filter=Compose</source>
        <translation>bench 之后的所有内容都交给 Google Benchmark，例如 --benchmark_filter=Compose</translation>
    </message>
    <message>
        <source>%1 (see %2 --help)</source>
        <translation>%1（见 %2 --help）</translation>
    </message>
    <message>
        <source>Did you mean %1?</source>
        <translation>您是不是想用 %1？</translation>
    </message>
    <message>
        <source>See mapwright --help.</source>
        <translation>见 mapwright --help。</translation>
    </message>
    <message>
        <source>%1 is neither a subcommand nor an existing file. %2</source>
        <translation>%1 既不是子命令，也不是已有的文件。%2</translation>
    </message>
    <message>
        <source>%1: there is no such file.</source>
        <translation>%1：没有这个文件。</translation>
    </message>
    <message>
        <source>mapwright had to stop: %1</source>
        <translation>mapwright 不得不停止：%1</translation>
    </message>
    <message>
        <source>--map %1: pass the id of a stored map (see mapwright maps list).</source>
        <translation>--map %1：请给出已存地图的 id（见 mapwright maps list）。</translation>
    </message>
    <message>
        <source>There is no map %1 (see mapwright maps list).</source>
        <translation>没有地图 %1（见 mapwright maps list）。</translation>
    </message>
    <message>
        <source>There are no maps.</source>
        <translation>没有地图。</translation>
    </message>
    <message>
        <source>None of its maps is the current one. Pass --map ID (see mapwright maps list).</source>
        <translation>其地图都不是当前地图。请使用 --map ID（见 mapwright maps list）。</translation>
    </message>
    <message>
        <source>The robot sends it by region.</source>
        <translation>机器人按分块发送地图。</translation>
    </message>
    <message>
        <source>It had not arrived in time.</source>
        <translation>未能及时到达。</translation>
    </message>
    <message>
        <source>--radius %1: give metres from 0 to %2, for example 0.3.</source>
        <translation>--radius %1：请给出 0 到 %2 的米数，例如 0.3。</translation>
    </message>
    <message>
        <source>The standard input</source>
        <translation>标准输入</translation>
    </message>
    <message>
        <source>File with the secret for the robot of --robot (or MAPWRIGHT_SECRET)</source>
        <translation>存放 --robot 机器人密钥的文件（或 MAPWRIGHT_SECRET）</translation>
    </message>
    <message>
        <source>Address of another robot, and the file with its secret; may be repeated</source>
        <translation>另一台机器人的地址，以及存放其密钥的文件；可重复使用</translation>
    </message>
    <message>
        <source>PEM file with certificate authorities (or self-signed certificates) to trust in addition to the system&apos;s</source>
        <translation>PEM 文件，内含除系统证书之外还要信任的证书颁发机构（或自签名证书）</translation>
    </message>
    <message>
        <source>Timeout in seconds</source>
        <translation>超时，单位为秒</translation>
    </message>
    <message>
        <source>Write a summary and all warnings as JSON</source>
        <translation>将摘要和所有警告写为 JSON</translation>
    </message>
    <message>
        <source>Replace an existing file</source>
        <translation>替换已有的文件</translation>
    </message>
    <message>
        <source>Print JSON</source>
        <translation>输出 JSON</translation>
    </message>
    <message>
        <source>--timeout must be greater than 0 and at most 86400 seconds.</source>
        <translation>--timeout 必须大于 0 且不超过 86400 秒。</translation>
    </message>
    <message>
        <source>the value is empty</source>
        <translation>值为空</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>“%1”不是数字</translation>
    </message>
    <message>
        <source>--tolerance must be a number from 0 to 255.</source>
        <translation>--tolerance 必须是 0 到 255 的数字。</translation>
    </message>
    <message>
        <source>--max-differing must be a percentage from 0 to 100.</source>
        <translation>--max-differing 必须是 0 到 100 的百分比。</translation>
    </message>
    <message>
        <source>%1 is not the report of a snapshot.</source>
        <translation>%1 不是快照的报告。</translation>
    </message>
    <message>
        <source>%1 is the report of a picture of %2 x %3: not of one of these.</source>
        <translation>%1 是一张 %2 x %3 图像的报告：不属于这些图像。</translation>
    </message>
    <message>
        <source>Compare two pictures pixel by pixel</source>
        <translation>逐像素比较两张图像</translation>
    </message>
    <message>
        <source>The expected picture</source>
        <translation>期望图像</translation>
    </message>
    <message>
        <source>The picture to compare with it</source>
        <translation>要与之比较的图像</translation>
    </message>
    <message>
        <source>Difference allowed for a channel of a pixel: 0 to 255</source>
        <translation>像素单个通道允许的差异：0 到 255</translation>
    </message>
    <message>
        <source>Share of pixels that may differ by more, in percent; dense clusters, such as a lost marker, never may</source>
        <translation>允许超出该差异的像素所占的百分比；密集的聚簇（例如丢失的标记）从不允许</translation>
    </message>
    <message>
        <source>A picture of the same size whose gray says by how much each pixel may differ</source>
        <translation>同样大小的图像，其灰度表示每个像素允许的差异</translation>
    </message>
    <message>
        <source>Write a picture of the differences (PNG)</source>
        <translation>写出差异图像 (PNG)</translation>
    </message>
    <message>
        <source>The report of the snapshot, for places in metres; by default the one beside a picture</source>
        <translation>快照的报告，用于以米表示位置；默认为图像旁边的报告</translation>
    </message>
    <message>
        <source>mapwright crashed. Please report it together with the lines that follow:</source>
        <translation>mapwright 崩溃了。请报告此问题，并附上以下各行：</translation>
    </message>
    <message>
        <source>No folder is writable, so the built-in fonts cannot be used. Labels may look different.</source>
        <translation>没有可写的文件夹，因此无法使用内置字体。标注的外观可能不同。</translation>
    </message>
    <message>
        <source>Example:</source>
        <translation>示例：</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>示例：</translation>
    </message>
    <message>
        <source>%1: give the number of a version (see mapwright overlays history list).</source>
        <translation>%1：请给出版本的编号（见 mapwright overlays history list）。</translation>
    </message>
    <message>
        <source>No versions are kept here.</source>
        <translation>这里没有保留任何版本。</translation>
    </message>
    <message>
        <source>NUMBER</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>DATE</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>VERSION</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>KEPT WHEN</source>
        <translation>保留时机</translation>
    </message>
    <message>
        <source>BYTES</source>
        <translation>字节数</translation>
    </message>
    <message>
        <source>MAP</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>ROBOT</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>read</source>
        <translation>已读取</translation>
    </message>
    <message>
        <source>Which robot? Pass --robot ADDRESS.</source>
        <translation>哪台机器人？请使用 --robot ADDRESS。</translation>
    </message>
    <message>
        <source>%1: no connection within %2 s (--timeout).</source>
        <translation>%1：%2 s 内未能连接 (--timeout)。</translation>
    </message>
    <message>
        <source>Log to standard error: all, parts of the program such as net,session, or rules of Qt such as mapwright.net.debug=true (or MAPWRIGHT_LOG)</source>
        <translation>向标准错误输出日志：all、程序的某些部分（如 net,session），或 Qt 的规则（如 mapwright.net.debug=true）（或 MAPWRIGHT_LOG）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no rule for the log. Give all, some of %2, or rules such as mapwright.net.debug=true.</source>
        <translation>“%1”不是日志规则。请给出 all、%2 中的若干项，或 mapwright.net.debug=true 之类的规则。</translation>
    </message>
    <message>
        <source>The picture of the differences cannot be encoded.</source>
        <translation>无法编码差异图像。</translation>
    </message>
    <message>
        <source>The two maps are too far apart or too large to be compared cell by cell.</source>
        <translation>两张地图相距太远或太大，无法逐栅格比较。</translation>
    </message>
    <message>
        <source>--resolution %1: give metres per cell, for example 0.05.</source>
        <translation>--resolution %1：请给出每栅格的米数，例如 0.05。</translation>
    </message>
    <message>
        <source>--robot %1 has no effect: neither map is one of its maps. Leave it out.</source>
        <translation>--robot %1 不起作用：两张地图都不是它的地图。请去掉。</translation>
    </message>
    <message>
        <source>It sends its map by region: pass --region X,Y,LX,LY.</source>
        <translation>它按分块发送地图：请使用 --region X,Y,LX,LY。</translation>
    </message>
    <message>
        <source>--region %1: give the centre and the side lengths in metres, X,Y,LX,LY, for example 10,-5,40,30.</source>
        <translation>--region %1：请给出中心和边长，单位为米，X,Y,LX,LY，例如 10,-5,40,30。</translation>
    </message>
    <message>
        <source>It sends no live map. Request one of its stored maps by id (see mapwright maps list).</source>
        <translation>它不发送实时地图。请按 id 请求其某张已存地图（见 mapwright maps list）。</translation>
    </message>
    <message>
        <source>To get the whole map, whatever its size, pass --mode whole.</source>
        <translation>要获取整张地图（无论多大），请使用 --mode whole。</translation>
    </message>
    <message>
        <source>Its map is empty.</source>
        <translation>其地图是空的。</translation>
    </message>
    <message>
        <source>Its whole map cannot be used.</source>
        <translation>其整张地图无法使用。</translation>
    </message>
    <message>
        <source>None of its %1 maps is the current one. Pass an id (see mapwright maps list).</source>
        <translation>其 %1 张地图都不是当前地图。请给出 id（见 mapwright maps list）。</translation>
    </message>
    <message>
        <source>Its messages name the map &quot;%1&quot;.</source>
        <translation>其消息中的地图名称为“%1”。</translation>
    </message>
    <message>
        <source>Its messages name the map &quot;%1&quot; (%2).</source>
        <translation>其消息中的地图名称为“%1”（%2）。</translation>
    </message>
    <message>
        <source>It is sending no map at the moment.</source>
        <translation>它目前没有发送地图。</translation>
    </message>
    <message>
        <source>It is sending no map at the moment, and none of its stored maps is the current one.</source>
        <translation>它目前没有发送地图，其已存地图也都不是当前地图。</translation>
    </message>
    <message>
        <source>The live map of the robot cannot be read. Its current stored map is shown.</source>
        <translation>无法读取机器人的实时地图。改为显示其当前的已存地图。</translation>
    </message>
    <message>
        <source>The robot is sending no map at the moment. Its current stored map is shown.</source>
        <translation>机器人目前没有发送地图。改为显示其当前的已存地图。</translation>
    </message>
    <message>
        <source>%1: pass the id of a stored map (see mapwright maps list).</source>
        <translation>%1：请给出已存地图的 id（见 mapwright maps list）。</translation>
    </message>
    <message>
        <source>--force replaces it.</source>
        <translation>用 --force 可替换它。</translation>
    </message>
    <message>
        <source>The robot has no data for this map by which it positions itself: only its picture and its overlays were downloaded.</source>
        <translation>机器人没有该地图用于定位的数据：只下载了其图像和覆盖物。</translation>
    </message>
    <message>
        <source>--as-new adds it as another map.</source>
        <translation>用 --as-new 可将其添加为另一张地图。</translation>
    </message>
    <message>
        <source>The robot accepted the map, but stored it differently: %1.</source>
        <translation>机器人接受了该地图，但存储的内容不同：%1。</translation>
    </message>
    <message>
        <source>--origin %1: give X,Y in metres, for example -10,-5.</source>
        <translation>--origin %1：请给出 X,Y，单位为米，例如 -10,-5。</translation>
    </message>
    <message>
        <source>%1 has transparent pixels: they are sent as gray, which is unknown.</source>
        <translation>%1 有透明像素：它们会以灰色下发，即未知。</translation>
    </message>
    <message>
        <source>%1: pass an image file (.pgm, .png) or its map.yaml.</source>
        <translation>%1：请给出图像文件（.pgm、.png）或其 map.yaml。</translation>
    </message>
    <message>
        <source>The image of this map cannot be set from here.</source>
        <translation>无法从这里设置该地图的图像。</translation>
    </message>
    <message>
        <source>%1 has %2 x %3 pixels, but the map has %4 x %5 cells. Nothing was sent.</source>
        <translation>%1 为 %2 x %3 像素，而地图为 %4 x %5 栅格。未下发任何内容。</translation>
    </message>
    <message numerus="yes">
        <source>%1 cells of the image are neither free nor occupied but in between: they are sent as map_server reads them (from 65 % occupied, below 19.6 % free, else unknown).</source>
        <translation>
            <numerusform>图像中有 %1 个栅格既非空闲也非占据，而是介于两者之间：按 map_server 的读法下发（65% 及以上为占据，低于 19.6% 为空闲，否则为未知）。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: the image was replaced, and the robot shows it.</source>
        <translation>%1：图像已替换，机器人已显示新图像。</translation>
    </message>
    <message>
        <source>Download a stored map with its positioning data, or resume an interrupted download</source>
        <translation>下载已存地图及其定位数据，或续传中断的下载</translation>
    </message>
    <message>
        <source>Id of a stored map</source>
        <translation>已存地图的 id</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>存放文件的文件夹</translation>
    </message>
    <message>
        <source>Replace the map in the folder</source>
        <translation>替换文件夹中的地图</translation>
    </message>
    <message>
        <source>Add a downloaded map to the robot&apos;s maps</source>
        <translation>将下载的地图添加到机器人的地图中</translation>
    </message>
    <message>
        <source>Folder of a finished download</source>
        <translation>已下载完成的文件夹</translation>
    </message>
    <message>
        <source>Give the map this name</source>
        <translation>为地图指定该名称</translation>
    </message>
    <message>
        <source>Add it as another map, with a new uid</source>
        <translation>添加为另一张地图，使用新的 uid</translation>
    </message>
    <message>
        <source>Replace the image of the robot&apos;s current map (KABAM)</source>
        <translation>替换机器人当前地图的图像 (KABAM)</translation>
    </message>
    <message>
        <source>Id of the map</source>
        <translation>地图的 id</translation>
    </message>
    <message>
        <source>A PGM or PNG of the same size, or its map.yaml: black occupied, white free, 205 unknown</source>
        <translation>同样大小的 PGM 或 PNG，或其 map.yaml：黑色为占据，白色为空闲，205 为未知</translation>
    </message>
    <message>
        <source>Add a map made from a picture</source>
        <translation>添加由图像制成的地图</translation>
    </message>
    <message>
        <source>Name of the new map</source>
        <translation>新地图的名称</translation>
    </message>
    <message>
        <source>A PNG: black occupied, white free, gray or transparent unknown</source>
        <translation>PNG：黑色为占据，白色为空闲，灰色或透明为未知</translation>
    </message>
    <message>
        <source>Metres per pixel</source>
        <translation>每像素的米数</translation>
    </message>
    <message>
        <source>X,Y of its lower left corner in metres</source>
        <translation>左下角的 X,Y，单位为米</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>%1 %2  x %3 m, y %4 m%5</source>
        <translation>%1 %2  x %3 m，y %4 m%5</translation>
    </message>
    <message>
        <source>, yaw %1 rad</source>
        <translation>，朝向 %1 rad</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>current</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>map name</source>
        <translation>地图名称</translation>
    </message>
    <message>
        <source>id</source>
        <translation>id</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>archived</source>
        <translation>已归档</translation>
    </message>
    <message>
        <source>The map manager is %1.</source>
        <translation>地图管理器处于 %1。</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>MAP NAME</source>
        <translation>地图名称</translation>
    </message>
    <message>
        <source>%1: none of its maps is the current one.</source>
        <translation>%1：其地图都不是当前地图。</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>栅格</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, yaw %3 rad (lower left corner)</source>
        <translation>x %1 m，y %2 m，朝向 %3 rad（左下角）</translation>
    </message>
    <message>
        <source>extent</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>%1 m x %2 m</source>
        <translation>%1 m x %2 m</translation>
    </message>
    <message>
        <source>overlays</source>
        <translation>覆盖物</translation>
    </message>
    <message>
        <source>Pass --allow-missing to write them all the same.</source>
        <translation>使用 --allow-missing 可仍然全部写出。</translation>
    </message>
    <message>
        <source>--map-mode, --occupied and --free need a map.yaml: name the output NAME.yaml, not %1.</source>
        <translation>--map-mode、--occupied 和 --free 需要 map.yaml：请将输出命名为 NAME.yaml，而不是 %1。</translation>
    </message>
    <message>
        <source>--map-mode %1: it must be trinary, scale or raw.</source>
        <translation>--map-mode %1：必须是 trinary、scale 或 raw。</translation>
    </message>
    <message>
        <source>--occupied and --free have no effect in mode raw.</source>
        <translation>--occupied 和 --free 在 raw 模式下不起作用。</translation>
    </message>
    <message>
        <source>A PGM cannot hold unknown cells in mode scale. Name the output NAME.yaml: its picture will be a PNG.</source>
        <translation>PGM 在 scale 模式下无法保存未知栅格。请将输出命名为 NAME.yaml：其图像将为 PNG。</translation>
    </message>
    <message>
        <source>--output %1: the name must end in .png, or in .pgm or .yaml to get both of these; or pass --format png or pgm.</source>
        <translation>--output %1：文件名必须以 .png 结尾，或以 .pgm 或 .yaml 结尾（同时得到这两个文件）；或者使用 --format png 或 pgm。</translation>
    </message>
    <message>
        <source>--output %1 contradicts --format %2.</source>
        <translation>--output %1 与 --format %2 矛盾。</translation>
    </message>
    <message>
        <source>Only a single PNG can be written to the standard output (--output %1).</source>
        <translation>只有单个 PNG 可以写到标准输出 (--output %1)。</translation>
    </message>
    <message>
        <source>--region only works with the live map, not with %1.</source>
        <translation>--region 只能用于实时地图，不能用于 %1。</translation>
    </message>
    <message>
        <source>%1: %2 x %3 cells of %4 m</source>
        <translation>%1：%2 x %3 栅格，每栅格 %4 m</translation>
    </message>
    <message numerus="yes">
        <source>%1 cells</source>
        <translation>
            <numerusform>%1 个栅格</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>occupied in the second only</source>
        <translation>仅在第二张中占据</translation>
    </message>
    <message>
        <source>occupied in the first only</source>
        <translation>仅在第一张中占据</translation>
    </message>
    <message>
        <source>known in the first only</source>
        <translation>仅在第一张中已知</translation>
    </message>
    <message>
        <source>known in the second only</source>
        <translation>仅在第二张中已知</translation>
    </message>
    <message>
        <source>same state, different gray level</source>
        <translation>状态相同，灰度不同</translation>
    </message>
    <message>
        <source>free in both</source>
        <translation>两张中均空闲</translation>
    </message>
    <message>
        <source>occupied in both</source>
        <translation>两张中均占据</translation>
    </message>
    <message>
        <source>The maps differ.</source>
        <translation>两张地图不同。</translation>
    </message>
    <message>
        <source>The maps are the same.</source>
        <translation>两张地图相同。</translation>
    </message>
    <message>
        <source>The parts of the maps that could be read are the same.</source>
        <translation>两张地图中能读取的部分相同。</translation>
    </message>
    <message>
        <source>Name the map: maps save NAME.</source>
        <translation>请为地图命名：maps save NAME。</translation>
    </message>
    <message>
        <source>Name the map: maps rename ID NAME.</source>
        <translation>请为地图命名：maps rename ID NAME。</translation>
    </message>
    <message>
        <source>Deleting a map cannot be undone. Pass --yes to delete %1.</source>
        <translation>删除地图后无法撤销。要删除 %1，请使用 --yes。</translation>
    </message>
    <message>
        <source>--waypoint: this robot does not ask where it stands when it loads a map. Leave it out.</source>
        <translation>--waypoint：该机器人加载地图时不询问所在位置。请去掉。</translation>
    </message>
    <message>
        <source>The robot wrote %1.</source>
        <translation>机器人写入了 %1。</translation>
    </message>
    <message>
        <source>Rename a stored map</source>
        <translation>重命名已存地图</translation>
    </message>
    <message>
        <source>Make a stored map the current one</source>
        <translation>将已存地图设为当前地图</translation>
    </message>
    <message>
        <source>Archive a stored map</source>
        <translation>归档已存地图</translation>
    </message>
    <message>
        <source>Restore a map from the archive</source>
        <translation>从归档中恢复地图</translation>
    </message>
    <message>
        <source>Delete a stored map (--yes)</source>
        <translation>删除已存地图 (--yes)</translation>
    </message>
    <message>
        <source>Start mapping</source>
        <translation>开始建图</translation>
    </message>
    <message>
        <source>End mapping; save stores the result</source>
        <translation>结束建图；用 save 保存结果</translation>
    </message>
    <message>
        <source>Store the result of mapping under a name</source>
        <translation>以某个名称保存建图结果</translation>
    </message>
    <message>
        <source>Maps stored on a robot or in a folder: list, export, compare, change</source>
        <translation>存放在机器人上或文件夹中的地图：列出、导出、比较、更改</translation>
    </message>
    <message>
        <source>Metres per cell, for a plain picture file or for submaps that are exported or compared (default: 0.05)</source>
        <translation>每栅格米数，用于纯图像文件，或用于导出或比较的子图（默认：0.05）</translation>
    </message>
    <message>
        <source>Id of a stored map, mapping:ID, live, or submaps; by default the live or current one</source>
        <translation>已存地图的 id、mapping:ID、live 或 submaps；默认为实时地图或当前地图</translation>
    </message>
    <message>
        <source>List all maps and mapping results; * marks the current one</source>
        <translation>列出所有地图和建图结果；* 表示当前地图</translation>
    </message>
    <message>
        <source>Show the robot&apos;s current map</source>
        <translation>显示机器人的当前地图</translation>
    </message>
    <message>
        <source>Show size, place, dates and waypoints of a map</source>
        <translation>显示地图的大小、位置、日期和路径点</translation>
    </message>
    <message>
        <source>Write a map as PNG, or as PGM and YAML for map_server</source>
        <translation>将地图写为 PNG，或写为供 map_server 使用的 PGM 和 YAML</translation>
    </message>
    <message>
        <source>Output file: NAME.png, or NAME.yaml / NAME.pgm (both); - writes a PNG to the standard output</source>
        <translation>输出文件：NAME.png，或 NAME.yaml / NAME.pgm（两者都写）；- 表示将 PNG 写到标准输出</translation>
    </message>
    <message>
        <source>png or pgm, if the file name does not say</source>
        <translation>png 或 pgm（文件名未说明时）</translation>
    </message>
    <message>
        <source>Also write a world file: NAME.pgw of a PNG, NAME.wld of a PGM</source>
        <translation>同时写出坐标文件 (world file)：PNG 为 NAME.pgw，PGM 为 NAME.wld</translation>
    </message>
    <message>
        <source>Write the map even if most of its picture is missing, as unknown cells</source>
        <translation>即使大部分图像缺失也写出地图，缺失处为未知栅格</translation>
    </message>
    <message>
        <source>How map_server reads the picture: trinary (default: walls, free and unknown as shown), or scale or raw (percentages)</source>
        <translation>map_server 读取图像的方式：trinary（默认：墙、空闲和未知按显示的样子），或 scale 或 raw（百分比）</translation>
    </message>
    <message>
        <source>occupied_thresh, 0 to 1: cells of a higher probability are walls. Without thresholds 0.65, with shades that keep all walls</source>
        <translation>occupied_thresh，0 到 1：概率更高的栅格为墙。不给阈值时为 0.65，并采用能保留所有墙的灰度</translation>
    </message>
    <message>
        <source>free_thresh, 0 to 1: cells of a lower probability are free (default: 0.196)</source>
        <translation>free_thresh，0 到 1：概率更低的栅格为空闲（默认：0.196）</translation>
    </message>
    <message>
        <source>Only this region of the live map of a map dispatcher (REP 130): X,Y,LX,LY, its centre and side lengths in metres</source>
        <translation>仅取地图分发器 (REP 130) 实时地图的这一区域：X,Y,LX,LY，即其中心和边长，单位为米</translation>
    </message>
    <message>
        <source>Make a map dispatcher (REP 130) write its map to a file on the robot</source>
        <translation>让地图分发器 (REP 130) 将其地图写入机器人上的文件</translation>
    </message>
    <message>
        <source>File name on the robot. Its extension selects the format: most know .png, .pgm or .yaml for grids and .pcd, .ply or .vtk for clouds</source>
        <translation>机器人上的文件名。扩展名决定格式：通常栅格地图支持 .png、.pgm 或 .yaml，点云支持 .pcd、.ply 或 .vtk</translation>
    </message>
    <message>
        <source>Compare two maps cell by cell; exit code 1 when they differ</source>
        <translation>逐栅格比较两张地图；不同时退出码为 1</translation>
    </message>
    <message>
        <source>A map of --robot (id, mapping:ID, live, submaps), or a file or address</source>
        <translation>--robot 的某张地图（id、mapping:ID、live、submaps），或者文件或地址</translation>
    </message>
    <message>
        <source>The same for the second map</source>
        <translation>第二张地图，写法相同</translation>
    </message>
    <message>
        <source>Write the differences as a PNG; - is the standard output</source>
        <translation>将差异写为 PNG；- 表示标准输出</translation>
    </message>
    <message>
        <source>Overwrite a file even if a map was read from it</source>
        <translation>即使从某个文件读取了地图也覆盖它</translation>
    </message>
    <message>
        <source>New name</source>
        <translation>新名称</translation>
    </message>
    <message>
        <source>Waypoint at which the robot stands</source>
        <translation>机器人所在的路径点</translation>
    </message>
    <message>
        <source>Extend the current map</source>
        <translation>扩展当前地图</translation>
    </message>
    <message>
        <source>Discard the result; this cannot be undone</source>
        <translation>放弃结果；无法撤销</translation>
    </message>
    <message>
        <source>--pair %1: give a point of the old map and the same point of the new one in metres, X,Y:X,Y.</source>
        <translation>--pair %1：请给出旧地图上的一个点和新地图上的同一个点，单位为米，X,Y:X,Y。</translation>
    </message>
    <message>
        <source>%1 (score %2)</source>
        <translation>%1（得分 %2）</translation>
    </message>
    <message>
        <source>old to new</source>
        <translation>旧到新</translation>
    </message>
    <message>
        <source>best candidate</source>
        <translation>最佳候选</translation>
    </message>
    <message>
        <source>second best</source>
        <translation>第二候选</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>重叠</translation>
    </message>
    <message>
        <source>walls of the old map</source>
        <translation>旧地图的墙</translation>
    </message>
    <message>
        <source>walls of the new map</source>
        <translation>新地图的墙</translation>
    </message>
    <message>
        <source>pair %1</source>
        <translation>点对 %1</translation>
    </message>
    <message>
        <source>off by %1 m</source>
        <translation>偏差 %1 m</translation>
    </message>
    <message>
        <source>%1 m: the maps are too large to be compared in cells of their own</source>
        <translation>%1 m：地图太大，无法按各自的栅格比较</translation>
    </message>
    <message>
        <source>--transform %1: give X,Y,YAW in metres and degrees, as maps align prints it.</source>
        <translation>--transform %1：请给出 X,Y,YAW，单位为米和度，格式同 maps align 的输出。</translation>
    </message>
    <message>
        <source>Pass either --transform or --pair.</source>
        <translation>--transform 和 --pair 只能使用其一。</translation>
    </message>
    <message>
        <source>Find out where an old map of a site lies on a new one</source>
        <translation>找出现场的旧地图在新地图上的位置</translation>
    </message>
    <message>
        <source>X,Y:X,Y: a point of the old map and the same point of the new one. One decides between candidates; two or more align the maps by themselves</source>
        <translation>X,Y:X,Y：旧地图上的一个点和新地图上的同一个点。一对用于在候选结果中做出选择；两对或更多则直接对齐地图</translation>
    </message>
    <message>
        <source>Metres per cell of a plain picture file or of submaps (default: 0.05)</source>
        <translation>纯图像文件或子图的每栅格米数（默认：0.05）</translation>
    </message>
    <message>
        <source>Write the old map above the new one as a PNG, with their differences; - is the standard output</source>
        <translation>将旧地图叠加在新地图上写为 PNG，并标出差异；- 表示标准输出</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>%1 is larger than 256 MiB.</source>
        <translation>%1 大于 256 MiB。</translation>
    </message>
    <message>
        <source>%1 is no track.</source>
        <translation>%1 不是行驶轨迹。</translation>
    </message>
    <message>
        <source>%1 is no track: line %2 cannot be read.</source>
        <translation>%1 不是行驶轨迹：无法读取第 %2 行。</translation>
    </message>
    <message>
        <source>Pass a recording, or a file that bags track wrote.</source>
        <translation>请给出录制文件，或 bags track 写出的文件。</translation>
    </message>
    <message>
        <source>--pair needs --from, the old map that it is a point of.</source>
        <translation>--pair 需要 --from，即该点所在的旧地图。</translation>
    </message>
    <message>
        <source>Nothing was rehearsed. %1</source>
        <translation>未进行预演。%1</translation>
    </message>
    <message>
        <source>MEETS</source>
        <translation>碰到</translation>
    </message>
    <message>
        <source>LENGTH (m)</source>
        <translation>长度 (m)</translation>
    </message>
    <message>
        <source>FROM (UTC)</source>
        <translation>从 (UTC)</translation>
    </message>
    <message>
        <source>TO (UTC)</source>
        <translation>到 (UTC)</translation>
    </message>
    <message>
        <source>Recorded ways on a new map</source>
        <translation>录制的路径在新地图上的情况</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Incomplete</source>
        <translation>不完整</translation>
    </message>
    <message>
        <source>Ways</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>What they cross</source>
        <translation>路径穿过的内容</translation>
    </message>
    <message>
        <source>Nothing.</source>
        <translation>无。</translation>
    </message>
    <message>
        <source>Meets</source>
        <translation>遇到</translation>
    </message>
    <message>
        <source>Length (m)</source>
        <translation>长度 (m)</translation>
    </message>
    <message>
        <source>From (UTC)</source>
        <translation>开始时间 (UTC)</translation>
    </message>
    <message>
        <source>To (UTC)</source>
        <translation>到 (UTC)</translation>
    </message>
    <message>
        <source>Find out what recorded ways cross on a new map</source>
        <translation>找出录制的路径在新地图上会穿过什么</translation>
    </message>
    <message>
        <source>The new map: a map of --robot, a file or address, or ID@ADDRESS</source>
        <translation>新地图：--robot 的某张地图、文件或地址，或 ID@ADDRESS</translation>
    </message>
    <message>
        <source>Recordings, by file or by name on --robot, or tracks that bags track wrote</source>
        <translation>录制文件（给出文件，或 --robot 上的名称），或 bags track 写出的行驶轨迹</translation>
    </message>
    <message>
        <source>The old map that they were driven on; it is aligned with the new one. Without it they lie on the new map as they are</source>
        <translation>行驶时所用的旧地图；会与新地图对齐。不给出时，路径按原样放在新地图上</translation>
    </message>
    <message>
        <source>Write the ways, cut where they meet something, as GeoJSON; - is the standard output</source>
        <translation>将路径在碰到东西处截断，写为 GeoJSON；- 表示标准输出</translation>
    </message>
    <message>
        <source>%1: the standard output is a terminal. Redirect it to a file or another program.</source>
        <translation>%1：标准输出是终端。请重定向到文件或其他程序。</translation>
    </message>
    <message>
        <source>%1 cannot be written: the folder %2 does not exist or is not writable.</source>
        <translation>无法写入 %1：文件夹 %2 不存在或不可写。</translation>
    </message>
    <message>
        <source>%1: only PNG is written here. Choose a name that ends in .png.</source>
        <translation>%1：这里只能写 PNG。请使用以 .png 结尾的文件名。</translation>
    </message>
    <message>
        <source>Only one of the outputs can go to the standard output.</source>
        <translation>只有一个输出可以写到标准输出。</translation>
    </message>
    <message>
        <source>%1 and %2 are the same file. Choose two different ones.</source>
        <translation>%1 和 %2 是同一个文件。请使用两个不同的文件。</translation>
    </message>
    <message>
        <source>%1 is a file that the map is read from. Pass --force to replace it.</source>
        <translation>%1 是地图的来源文件。要替换它，请使用 --force。</translation>
    </message>
    <message>
        <source>%1 is a file that this command reads. Choose another one for --report.</source>
        <translation>%1 是此命令要读取的文件。请为 --report 使用另一个文件。</translation>
    </message>
    <message>
        <source>%1 is the recording itself. Choose another name.</source>
        <translation>%1 是录制文件本身。请使用另一个名称。</translation>
    </message>
    <message>
        <source>%1 already exists. Pass --force to replace it.</source>
        <translation>%1 已存在。要替换它，请使用 --force。</translation>
    </message>
    <message>
        <source>The standard output cannot be written.</source>
        <translation>无法写入标准输出。</translation>
    </message>
    <message>
        <source>The standard output cannot be written: %1.</source>
        <translation>无法写入标准输出：%1。</translation>
    </message>
    <message>
        <source>add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>change</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>CHANGE</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>WHAT</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>CONFLICT</source>
        <translation>冲突</translation>
    </message>
    <message>
        <source>BASE</source>
        <translation>基准</translation>
    </message>
    <message>
        <source>MINE</source>
        <translation>我的</translation>
    </message>
    <message>
        <source>THEIRS</source>
        <translation>对方的</translation>
    </message>
    <message>
        <source>(not there)</source>
        <translation>（没有）</translation>
    </message>
    <message>
        <source>No flaws.</source>
        <translation>没有缺陷。</translation>
    </message>
    <message>
        <source>RULE</source>
        <translation>规则</translation>
    </message>
    <message>
        <source>FEATURE</source>
        <translation>要素</translation>
    </message>
    <message>
        <source>FLAW</source>
        <translation>缺陷</translation>
    </message>
    <message>
        <source>%1 is no GeoJSON FeatureCollection with a list of features.</source>
        <translation>%1 不是带有要素列表的 GeoJSON FeatureCollection。</translation>
    </message>
    <message>
        <source>%1 has something among its features that is no feature: %2</source>
        <translation>%1 的要素中有一项不是要素：%2</translation>
    </message>
    <message numerus="yes">
        <source>%1 features</source>
        <translation>
            <numerusform>%1 个要素</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Nothing was sent: %1 conflicts with what others changed since the base.</source>
        <translation>
            <numerusform>未下发任何内容：%1 处与他人自基准以来的修改冲突。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing was sent: this deletes %1 of the %2 features on the robot. Pass --yes to do it.</source>
        <translation>未下发任何内容：这会删除机器人上 %2 个要素中的 %1 个。要执行，请使用 --yes。</translation>
    </message>
    <message>
        <source>Earlier versions are in mapwright overlays history.</source>
        <translation>较早的版本见 mapwright overlays history。</translation>
    </message>
    <message>
        <source>Nothing to change.</source>
        <translation>没有需要更改的内容。</translation>
    </message>
    <message>
        <source>The robot holds this already.</source>
        <translation>机器人上已是这些内容。</translation>
    </message>
    <message>
        <source>Stored in the file, and read back.</source>
        <translation>已存入文件，并读回验证。</translation>
    </message>
    <message>
        <source>Stored on the robot as version %1, and read back.</source>
        <translation>已作为版本 %1 存入机器人，并读回验证。</translation>
    </message>
    <message>
        <source>Stored on the robot, and read back.</source>
        <translation>已存入机器人，并读回验证。</translation>
    </message>
    <message>
        <source>Pass --base B.geojson, the file that you edited as overlays get wrote it, so that what others change stays; or --replace to replace everything.</source>
        <translation>请使用 --base B.geojson，即您编辑的文件在 overlays get 写出时的样子，这样他人的修改会保留；或用 --replace 全部替换。</translation>
    </message>
    <message>
        <source>Pass --base B.geojson, the file that you edited as overlays get wrote it.</source>
        <translation>请使用 --base B.geojson，即您编辑的文件在 overlays get 写出时的样子。</translation>
    </message>
    <message>
        <source>Pass either --base or --replace.</source>
        <translation>--base 和 --replace 只能使用其一。</translation>
    </message>
    <message>
        <source>Only one of the files can be the standard input.</source>
        <translation>只有一个文件可以来自标准输入。</translation>
    </message>
    <message>
        <source>%1 is larger than 32 MiB: no robot could give it back.</source>
        <translation>%1 大于 32 MiB：没有机器人能再返回它。</translation>
    </message>
    <message>
        <source>--off %1: there is no such rule. Rules are: %2.</source>
        <translation>--off %1：没有这条规则。规则有：%2。</translation>
    </message>
    <message>
        <source>--map %1: pass --robot ADDRESS, too, or a map file as --robot.</source>
        <translation>--map %1：请同时使用 --robot ADDRESS，或将地图文件作为 --robot。</translation>
    </message>
    <message>
        <source>Without --robot what lies on the map is not checked.</source>
        <translation>没有 --robot 时，不检查地图上的内容。</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>没有差异。</translation>
    </message>
    <message>
        <source>Earlier versions seen on this computer: list, show, restore</source>
        <translation>本机见过的较早版本：列出、显示、恢复</translation>
    </message>
    <message>
        <source>Number of the version, see history list</source>
        <translation>版本的编号，见 history list</translation>
    </message>
    <message>
        <source>List the versions, newest first; needs no connection</source>
        <translation>列出各版本，最新的在前；不需要连接</translation>
    </message>
    <message>
        <source>Only of this robot (or MAPWRIGHT_ROBOT)</source>
        <translation>只列该机器人的（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>Only of this map: its id, uid or name</source>
        <translation>只列该地图的：其 id、uid 或名称</translation>
    </message>
    <message>
        <source>Show what a version changed, or write it to a file</source>
        <translation>显示某个版本更改了什么，或将其写入文件</translation>
    </message>
    <message>
        <source>Compare with this version, not with the one before it</source>
        <translation>与该版本比较，而不是与前一个版本比较</translation>
    </message>
    <message>
        <source>Write the version as GeoJSON; - is the standard output</source>
        <translation>将该版本写为 GeoJSON；- 表示标准输出</translation>
    </message>
    <message>
        <source>Replace the robot&apos;s overlays with a version</source>
        <translation>用某个版本替换机器人的覆盖物</translation>
    </message>
    <message>
        <source>Id of a stored map; by default the version&apos;s own</source>
        <translation>已存地图的 id；默认为该版本自身的地图</translation>
    </message>
    <message>
        <source>Print the changes, send nothing</source>
        <translation>输出更改，不下发</translation>
    </message>
    <message>
        <source>Overlays of a map (walls, regions, doors, chargers): read, change, check</source>
        <translation>地图的覆盖物（墙、区域、门、充电桩）：读取、更改、检查</translation>
    </message>
    <message>
        <source>Id of a stored map; by default the current one</source>
        <translation>已存地图的 id；默认为当前地图</translation>
    </message>
    <message>
        <source>Write the overlays to a file, byte for byte as the robot keeps them</source>
        <translation>将覆盖物写入文件，与机器人保存的逐字节相同</translation>
    </message>
    <message>
        <source>GeoJSON file; - is the standard output</source>
        <translation>GeoJSON 文件；- 表示标准输出</translation>
    </message>
    <message>
        <source>The edited GeoJSON file; - is the standard input</source>
        <translation>编辑后的 GeoJSON 文件；- 表示标准输入</translation>
    </message>
    <message>
        <source>The file that overlays get wrote: only what differs from it is changed</source>
        <translation>overlays get 写出的文件：只更改与之不同的部分</translation>
    </message>
    <message>
        <source>Merge your changes into the robot&apos;s overlays</source>
        <translation>将您的更改合并到机器人的覆盖物中</translation>
    </message>
    <message>
        <source>Replace all overlays of the robot, without a base</source>
        <translation>不使用基准，替换机器人的所有覆盖物</translation>
    </message>
    <message>
        <source>Even if more features are deleted than kept</source>
        <translation>即使删除的要素多于保留的也执行</translation>
    </message>
    <message>
        <source>Show what set would change and what conflicts; sends nothing</source>
        <translation>显示 set 会更改什么、有什么冲突；不下发</translation>
    </message>
    <message>
        <source>Write the plan as JSON; - is the standard output</source>
        <translation>将方案写为 JSON；- 表示标准输出</translation>
    </message>
    <message>
        <source>Check a file or the robot&apos;s overlays; exit code 1 if there are flaws</source>
        <translation>检查文件或机器人的覆盖物；有缺陷时退出码为 1</translation>
    </message>
    <message>
        <source>GeoJSON file; by default the robot&apos;s overlays</source>
        <translation>GeoJSON 文件；默认为机器人的覆盖物</translation>
    </message>
    <message>
        <source>Rules to skip, separated by commas</source>
        <translation>要跳过的规则，用逗号分隔</translation>
    </message>
    <message>
        <source>Radius of the robot in metres; by default from its footprint, or 0.3</source>
        <translation>机器人半径，单位为米；默认由机器人外形得出，否则为 0.3</translation>
    </message>
    <message>
        <source>--at %1: give X,Y,YAW: metres, and the heading in degrees, for example 1.5,-2,90.</source>
        <translation>--at %1：请给出 X,Y,YAW：米，朝向为度，例如 1.5,-2,90。</translation>
    </message>
    <message>
        <source>The robot is searching its map for its position…</source>
        <translation>机器人正在其地图中搜索自己的位置…</translation>
    </message>
    <message>
        <source>mapwright maps set-pose --at %1,%2,%3 does.</source>
        <translation>请用 mapwright maps set-pose --at %1,%2,%3。</translation>
    </message>
    <message>
        <source>Tell the robot where it is on its current map</source>
        <translation>告诉机器人它在当前地图上的位置</translation>
    </message>
    <message>
        <source>X,Y,YAW in metres and degrees</source>
        <translation>X,Y,YAW，单位为米和度</translation>
    </message>
    <message>
        <source>Let the robot correct the pose with its sensors</source>
        <translation>让机器人用传感器修正位姿</translation>
    </message>
    <message>
        <source>Let the robot find itself on its current map</source>
        <translation>让机器人在当前地图上自行重定位</translation>
    </message>
    <message>
        <source>ADDRESS</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>IT SAYS</source>
        <translation>机器人自述</translation>
    </message>
    <message>
        <source>%1 is not a host. Give its name or address, with or without a port, for example 192.168.25.25 or dock-3.local:8090.</source>
        <translation>%1 不是主机。请给出其名称或地址，可带端口，例如 192.168.25.25 或 dock-3.local:8090。</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>%1: no robot answers there. --details says why, port by port.</source>
        <translation>%1：没有机器人应答。--details 会逐个端口说明原因。</translation>
    </message>
    <message>
        <source>%1: no robot answers there: %2.</source>
        <translation>%1：没有机器人应答：%2。</translation>
    </message>
    <message>
        <source>Find the robots at a host and their addresses</source>
        <translation>查找某台主机上的机器人及其地址</translation>
    </message>
    <message>
        <source>Name or address, for example dock-3.local; with a port, only that port is asked</source>
        <translation>名称或地址，例如 dock-3.local；带端口时只询问该端口</translation>
    </message>
    <message>
        <source>Say for each port why there is no robot</source>
        <translation>逐个端口说明为何没有机器人</translation>
    </message>
    <message>
        <source>--projection %1: give X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z in metres, from the lower left corner, followed by the frame if it is not that of the map.</source>
        <translation>--projection %1：请给出 X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z，单位为米，自左下角起；坐标系与地图不同时，在其后给出坐标系。</translation>
    </message>
    <message>
        <source>There are no projections.</source>
        <translation>没有投影。</translation>
    </message>
    <message>
        <source>WIDTH (m)</source>
        <translation>宽度 (m)</translation>
    </message>
    <message>
        <source>HEIGHT (m)</source>
        <translation>高度 (m)</translation>
    </message>
    <message>
        <source>MIN Z (m)</source>
        <translation>最小 Z (m)</translation>
    </message>
    <message>
        <source>MAX Z (m)</source>
        <translation>最大 Z (m)</translation>
    </message>
    <message>
        <source>FRAME</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>%1: it had no effect.</source>
        <translation>%1：没有生效。</translation>
    </message>
    <message>
        <source>Its set_map_projections has the type that REP 130 defines, which has no fields: projections can only be read (mapwright projections list).</source>
        <translation>其 set_map_projections 是 REP 130 定义的类型，没有字段：投影只能读取 (mapwright projections list)。</translation>
    </message>
    <message>
        <source>The robot accepted it, but does not project what was requested.</source>
        <translation>机器人接受了，但没有投影所请求的内容。</translation>
    </message>
    <message>
        <source>projections set: pass --projection, once for each one, or --none.</source>
        <translation>projections set：请使用 --projection（每个投影一次），或 --none。</translation>
    </message>
    <message>
        <source>Projections of a map dispatcher&apos;s 3D map onto a plane (REP 130): list, set</source>
        <translation>地图分发器的 3D 地图到平面的投影 (REP 130)：列出、设置</translation>
    </message>
    <message>
        <source>List the current projections</source>
        <translation>列出当前的投影</translation>
    </message>
    <message>
        <source>Replace all projections, then print what the robot projects</source>
        <translation>替换所有投影，然后输出机器人实际的投影</translation>
    </message>
    <message>
        <source>X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z in metres, from the lower left corner, and ,FRAME if it is not that of the map; may be repeated</source>
        <translation>X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z，单位为米，自左下角起；坐标系与地图不同时加上 ,FRAME；可重复使用</translation>
    </message>
    <message>
        <source>Project nothing</source>
        <translation>不投影</translation>
    </message>
    <message>
        <source>--streams: &quot;%1&quot; is unknown. Choose from: all, none, %2.</source>
        <translation>--streams：未知的“%1”。可选：all、none、%2。</translation>
    </message>
    <message>
        <source>--submaps must be all, listed or none, not &quot;%1&quot;.</source>
        <translation>--submaps 必须是 all、listed 或 none，不能是“%1”。</translation>
    </message>
    <message>
        <source>--duration must be greater than 0 seconds and at most 100000000.</source>
        <translation>--duration 必须大于 0 秒且不超过 100000000。</translation>
    </message>
    <message>
        <source>A recording must go to a regular file (-o FILE), because its index is written at the end.</source>
        <translation>录制必须保存到普通文件 (-o FILE)，因为索引在最后写入。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The connection was lost after %1 s. %2</source>
        <translation>%1 s 后连接丢失。%2</translation>
    </message>
    <message>
        <source>Reconnected after %1 s.</source>
        <translation>%1 s 后已重新连接。</translation>
    </message>
    <message>
        <source>Recording to %1 continues.</source>
        <translation>继续录制到 %1。</translation>
    </message>
    <message>
        <source>%1 s, %2, messages: %3</source>
        <translation>%1 s，%2，消息：%3</translation>
    </message>
    <message>
        <source>, lost: %1</source>
        <translation>，丢失：%1</translation>
    </message>
    <message>
        <source>%1: %2 s, %3, messages: %4, files: %5</source>
        <translation>%1：%2 s，%3，消息：%4，文件：%5</translation>
    </message>
    <message>
        <source>Incomplete: messages were lost because the disk or this computer was too slow: %1 (%2).</source>
        <translation>不完整：由于磁盘或本机太慢而丢失了消息：%1（%2）。</translation>
    </message>
    <message>
        <source>Nothing arrived on %1: %2</source>
        <translation>%1 上没有收到任何内容：%2</translation>
    </message>
    <message>
        <source>the robot has this topic but sent nothing.</source>
        <translation>机器人有该话题，但没有发送内容。</translation>
    </message>
    <message>
        <source>the robot does not list this topic.</source>
        <translation>机器人没有列出该话题。</translation>
    </message>
    <message>
        <source>%1 is not a robot that sends messages: there is nothing to record.</source>
        <translation>%1 不是会发送消息的机器人：没有可录制的内容。</translation>
    </message>
    <message>
        <source>Record what a robot sends to a file, including its maps</source>
        <translation>将机器人发送的内容录制到文件，包括其地图</translation>
    </message>
    <message>
        <source>For example 90s, 2m or 1h, or a number of seconds; by default until Ctrl+C</source>
        <translation>例如 90s、2m 或 1h，或秒数；默认直到按下 Ctrl+C</translation>
    </message>
    <message>
        <source>Additional topics, separated by commas, as the robot names them</source>
        <translation>额外的话题，用逗号分隔，使用机器人上的名称</translation>
    </message>
    <message>
        <source>Kinds of data, separated by commas: all, none, %1</source>
        <translation>数据种类，用逗号分隔：all、none、%1</translation>
    </message>
    <message>
        <source>listed (each submap once), all (every version) or none</source>
        <translation>listed（每个子图一次）、all（每个版本）或 none</translation>
    </message>
    <message>
        <source>Timeout for connecting in seconds</source>
        <translation>连接超时，单位为秒</translation>
    </message>
    <message>
        <source>%1 (and %2 more; --report lists them)</source>
        <translation>%1（还有 %2 项；用 --report 可全部列出）</translation>
    </message>
    <message>
        <source>The secret must be one line of at most 4096 bytes.</source>
        <translation>密钥必须是一行，且不超过 4096 字节。</translation>
    </message>
    <message>
        <source>The secret file %1 cannot be read: %2.</source>
        <translation>无法读取密钥文件 %1：%2。</translation>
    </message>
    <message>
        <source>--secret-file-for %1: give the address of a robot, followed by the file.</source>
        <translation>--secret-file-for %1：请给出机器人的地址，其后是文件。</translation>
    </message>
    <message>
        <source>--secret-file needs --robot. For another robot pass --secret-file-for ADDRESS FILE.</source>
        <translation>--secret-file 需要 --robot。对于另一台机器人，请使用 --secret-file-for ADDRESS FILE。</translation>
    </message>
    <message>
        <source>. If it is signed by your own authority, pass --ca-file PEM.</source>
        <translation>。如果它由您自己的机构签发，请使用 --ca-file PEM。</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>it did not answer within %1 s</source>
        <translation>它在 %1 s 内没有应答</translation>
    </message>
    <message>
        <source>The robot has not answered within %1 s whether it can be edited. Nothing was changed: try again, or wait longer (--timeout).</source>
        <translation>机器人在 %1 s 内没有应答能否编辑。未更改任何内容：请重试，或等待更久 (--timeout)。</translation>
    </message>
    <message>
        <source>Which robot? Pass --robot ADDRESS or set MAPWRIGHT_ROBOT; a file works too.</source>
        <translation>哪台机器人？请使用 --robot ADDRESS 或设置 MAPWRIGHT_ROBOT；文件也可以。</translation>
    </message>
    <message>
        <source>no connection within %1 s.</source>
        <translation>%1 s 内未能连接。</translation>
    </message>
    <message>
        <source>It did not answer within %1 s.</source>
        <translation>它在 %1 s 内没有应答。</translation>
    </message>
    <message>
        <source>%1: pass the id of a map (see mapwright maps list).</source>
        <translation>%1：请给出地图的 id（见 mapwright maps list）。</translation>
    </message>
    <message>
        <source>The map had not arrived within %1 s.</source>
        <translation>地图在 %1 s 内没有到达。</translation>
    </message>
    <message>
        <source>Not everything had arrived within %1 s (--timeout).</source>
        <translation>%1 s 内没有全部到达 (--timeout)。</translation>
    </message>
    <message>
        <source>The robot sent no readable submap list within %1 s (--timeout).</source>
        <translation>机器人在 %1 s 内没有发送可读的子图列表 (--timeout)。</translation>
    </message>
    <message>
        <source>The robot sent no submap list within %1 s (--timeout).</source>
        <translation>机器人在 %1 s 内没有发送子图列表 (--timeout)。</translation>
    </message>
    <message>
        <source>It has no submaps yet.</source>
        <translation>它还没有子图。</translation>
    </message>
    <message>
        <source>None of its submaps has a slice %1.</source>
        <translation>其子图都没有切片 %1。</translation>
    </message>
    <message>
        <source>None of its submaps could be loaded. %1</source>
        <translation>其子图都无法加载。%1</translation>
    </message>
    <message>
        <source>%1 of %2 submaps had arrived, but drawing them took longer than %3 s (--timeout).</source>
        <translation>已到达 %2 个子图中的 %1 个，但绘制用时超过 %3 s (--timeout)。</translation>
    </message>
    <message>
        <source>Its map is empty in this region.</source>
        <translation>其地图在该区域中是空的。</translation>
    </message>
    <message>
        <source>Its answer has too many cells in a row.</source>
        <translation>其应答中一行的栅格太多。</translation>
    </message>
    <message>
        <source>It answered with another part of its map, around %1 m, %2 m.</source>
        <translation>它应答的是地图的另一部分，在 %1 m，%2 m 附近。</translation>
    </message>
    <message>
        <source>Its answer covers %1 of the %2 m requested: either its map ends there, or it does not send more at once.</source>
        <translation>其应答覆盖所请求 %2 m 中的 %1 m：可能地图到此为止，也可能它一次只发送这么多。</translation>
    </message>
    <message>
        <source>Incomplete: the command did not finish within %1 s (--timeout).</source>
        <translation>不完整：命令在 %1 s 内没有完成 (--timeout)。</translation>
    </message>
    <message>
        <source>Incomplete. %1</source>
        <translation>不完整。%1</translation>
    </message>
    <message>
        <source>%1 is a Cartographer state file: leave out the part after the ?.</source>
        <translation>%1 是 Cartographer 状态文件：请去掉 ? 之后的部分。</translation>
    </message>
    <message>
        <source>%1: ?ns= names a robot in a recording, and this is none.</source>
        <translation>%1：?ns= 指定录制文件中的一台机器人，而这不是录制文件。</translation>
    </message>
    <message>
        <source>There is no scene &quot;%1&quot;. Choose one of: %2.</source>
        <translation>没有场景“%1”。可选：%2。</translation>
    </message>
    <message>
        <source>demo: accepts scene, submaps, seed and at, but not &quot;%1&quot;.</source>
        <translation>demo: 可用 scene、submaps、seed 和 at，不能用“%1”。</translation>
    </message>
    <message>
        <source>demo: %1 cannot be &quot;%2&quot;.</source>
        <translation>demo: 的 %1 不能是“%2”。</translation>
    </message>
    <message>
        <source>%1 is a recording, so its map depends on the time. Commands with --bag and --at read it there.</source>
        <translation>%1 是录制文件，因此其地图随时间变化。带 --bag 和 --at 的命令可以读取。</translation>
    </message>
    <message>
        <source>--resolution and --origin</source>
        <translation>--resolution 和 --origin</translation>
    </message>
    <message>
        <source>%1: only for a plain picture file. A robot reports itself where its maps are.</source>
        <translation>%1：仅用于纯图像文件。机器人会自行上报其地图的位置。</translation>
    </message>
    <message>
        <source>%1: the address already contains it after the ?. Give it only once.</source>
        <translation>%1：地址在 ? 之后已包含它。只能给出一次。</translation>
    </message>
    <message>
        <source>%1: only for a plain picture file. %2 states itself where its map is.</source>
        <translation>%1：仅用于纯图像文件。%2 自己说明了其地图的位置。</translation>
    </message>
    <message>
        <source>No kind of robot supports the address %1.</source>
        <translation>没有哪种机器人支持地址 %1。</translation>
    </message>
    <message>
        <source>Whether a map made of submaps is good</source>
        <translation>由子图构成的地图是否良好</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>--cell must be from %1 to %2 metres.</source>
        <translation>--cell 必须在 %1 到 %2 米之间。</translation>
    </message>
    <message>
        <source>--tolerance must be a number of cells from 0 to %1.</source>
        <translation>--tolerance 必须是 0 到 %1 的栅格数。</translation>
    </message>
    <message>
        <source>--fail-over must be a share from 0 to 1, for example 0.05 for 5 %.</source>
        <translation>--fail-over 必须是 0 到 1 的比例，例如 0.05 表示 5%。</translation>
    </message>
    <message>
        <source>--bag and --at belong together.</source>
        <translation>--bag 和 --at 必须一起使用。</translation>
    </message>
    <message>
        <source>--output %1: the name must end in .png.</source>
        <translation>--output %1：文件名必须以 .png 结尾。</translation>
    </message>
    <message>
        <source>--world-file needs the file of a picture (--output).</source>
        <translation>--world-file 需要图像文件 (--output)。</translation>
    </message>
    <message>
        <source>The bag contains no submap list up to this time.</source>
        <translation>到该时间为止，数据包中没有子图列表。</translation>
    </message>
    <message>
        <source>Choose a larger --cell.</source>
        <translation>请使用更大的 --cell。</translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps lie too far away to be compared: %2.</source>
        <translation>
            <numerusform>%1 个子图太远，无法比较：%2。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 tiles compared</source>
        <translation>已比较 %1 块，共 %2 块</translation>
    </message>
    <message>
        <source>Comparing the submaps took longer than %1 s (--timeout).</source>
        <translation>比较子图用时超过 %1 s (--timeout)。</translation>
    </message>
    <message>
        <source>There is nothing to draw: no submap saw anything.</source>
        <translation>没有可绘制的内容：没有子图看到任何东西。</translation>
    </message>
    <message>
        <source>The picture would have %1 x %2 pixels, one for each cell. At most %3 a side and %4 million in all are possible: choose a larger --cell.</source>
        <translation>图像将为 %1 x %2 像素，每栅格一个。每边最多 %3，总共最多 %4 百万：请使用更大的 --cell。</translation>
    </message>
    <message>
        <source>There is not enough memory for the picture.</source>
        <translation>内存不足以存放图像。</translation>
    </message>
    <message>
        <source>%1 of the %2 occupied cells contradict: %3 cells of %4 m (tolerance: %5 cells).</source>
        <translation>%2 个占据栅格中有 %1 个相互矛盾：%3 个 %4 m 的栅格（容差：%5 个栅格）。</translation>
    </message>
    <message>
        <source>CELLS</source>
        <translation>栅格数</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>SUBMAPS (occupied/free)</source>
        <translation>子图（占据/空闲）</translation>
    </message>
    <message numerus="yes">
        <source>… and %1 more places (--csv or --json for all)</source>
        <translation>
            <numerusform>… 还有 %1 处（--csv 或 --json 可得到全部）</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 cells of %2 m were seen, %3 of them by one submap alone.</source>
        <translation>共见到 %1 个 %2 m 的栅格，其中 %3 个只由一个子图见到。</translation>
    </message>
    <message>
        <source>SUBMAPS</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>SHARE</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>%1 of the occupied cells contradict: more than the %2 % of --fail-over.</source>
        <translation>占据栅格中有 %1 相互矛盾：超过 --fail-over 的 %2%。</translation>
    </message>
    <message>
        <source>Read recorded submaps: the name of a bag, or a file, with --at; FILE?ns=/NAMESPACE is one robot of several</source>
        <translation>读取录制的子图：数据包的名称或文件，配合 --at；FILE?ns=/NAMESPACE 表示多台机器人中的一台</translation>
    </message>
    <message>
        <source>Metres per cell of the world, on which the submaps are compared</source>
        <translation>比较子图所用的世界栅格的每栅格米数</translation>
    </message>
    <message>
        <source>Also write a world file (.pgw): where the picture lies</source>
        <translation>同时写出坐标文件 (world file) (.pgw)：说明图像的位置</translation>
    </message>
    <message>
        <source>Robot address or state file (or MAPWRIGHT_ROBOT)</source>
        <translation>机器人地址或状态文件（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>Find where submaps contradict each other</source>
        <translation>找出子图相互矛盾的地方</translation>
    </message>
    <message>
        <source>Walls that lie apart by so many cells are the same wall</source>
        <translation>相距不超过这么多栅格的墙视为同一面墙</translation>
    </message>
    <message>
        <source>Exit with 1 if a larger share of the occupied cells contradicts, for example 0.05</source>
        <translation>占据栅格中相互矛盾的比例更大时以 1 退出，例如 0.05</translation>
    </message>
    <message>
        <source>Write a picture (PNG): what contradicts is yellow to red, one pixel a cell</source>
        <translation>写出图像 (PNG)：矛盾处由黄到红，每栅格一个像素</translation>
    </message>
    <message>
        <source>Write all places where submaps contradict each other, as squares of 1 m (CSV)</source>
        <translation>写出子图相互矛盾的所有地方，以 1 m 的方格表示 (CSV)</translation>
    </message>
    <message>
        <source>Count how many submaps saw each cell</source>
        <translation>统计每个栅格被多少个子图见到</translation>
    </message>
    <message>
        <source>Write a picture (PNG): what was seen once is hatched, one pixel a cell</source>
        <translation>写出图像 (PNG)：只见过一次的部分画斜线，每栅格一个像素</translation>
    </message>
    <message>
        <source>Write what was seen, and seen once, in each square of 1 m (CSV)</source>
        <translation>写出每个 1 m 方格中见到的和只见过一次的内容 (CSV)</translation>
    </message>
    <message>
        <source>--submap %1: give trajectory and index, for example 0-4.</source>
        <translation>--submap %1：请给出轨迹和序号，例如 0-4。</translation>
    </message>
    <message>
        <source>--closure %1: give submap and node, for example 0-4:0-512.</source>
        <translation>--closure %1：请给出子图和节点，例如 0-4:0-512。</translation>
    </message>
    <message>
        <source>Leave out what? Pass --trajectory, --submap or --closure.</source>
        <translation>去掉什么？请使用 --trajectory、--submap 或 --closure。</translation>
    </message>
    <message>
        <source>%1: this needs a Cartographer state file (.pbstream).</source>
        <translation>%1：这需要 Cartographer 状态文件 (.pbstream)。</translation>
    </message>
    <message>
        <source>%1: the new file is read back, so it cannot be written there.</source>
        <translation>%1：新文件会被读回，因此不能写到那里。</translation>
    </message>
    <message>
        <source>Write a new state file with something left out</source>
        <translation>写出去掉某些内容的新状态文件</translation>
    </message>
    <message>
        <source>State file (.pbstream)</source>
        <translation>状态文件 (.pbstream)</translation>
    </message>
    <message>
        <source>A trajectory, with all that belongs to it</source>
        <translation>一条轨迹，连同属于它的一切</translation>
    </message>
    <message>
        <source>T-I: a submap, with its constraints</source>
        <translation>T-I：一个子图，连同其约束</translation>
    </message>
    <message>
        <source>T-I:T-N: the loop closure of a submap and a node</source>
        <translation>T-I:T-N：子图与节点之间的回环</translation>
    </message>
    <message>
        <source>The new file; nothing may be there</source>
        <translation>新文件；该处不能已有文件</translation>
    </message>
    <message>
        <source>Which file? Pass --robot FILE.pbstream or set MAPWRIGHT_ROBOT.</source>
        <translation>哪个文件？请使用 --robot FILE.pbstream 或设置 MAPWRIGHT_ROBOT。</translation>
    </message>
    <message>
        <source>%1: reading it took longer than %2 s (--timeout).</source>
        <translation>%1：读取用时超过 %2 s (--timeout)。</translation>
    </message>
    <message>
        <source>Submaps whose place is none, as a number is not finite or it has no direction: %1 (%2).</source>
        <translation>位置无效的子图（数值不是有限数，或没有方向）：%1（%2）。</translation>
    </message>
    <message>
        <source>No loop was closed: this map is odometry and scan matching only.</source>
        <translation>没有闭合任何回环：该地图仅来自里程计和扫描匹配。</translation>
    </message>
    <message>
        <source>Nodes without a pose in the pose graph: %1.</source>
        <translation>在位姿图中没有位姿的节点：%1。</translation>
    </message>
    <message>
        <source>Constraints that refer to submaps or nodes that are not there: %1.</source>
        <translation>引用不存在的子图或节点的约束：%1。</translation>
    </message>
    <message>
        <source>Constraints without a usable pose: %1.</source>
        <translation>没有可用位姿的约束：%1。</translation>
    </message>
    <message>
        <source>There are no submaps in it.</source>
        <translation>其中没有子图。</translation>
    </message>
    <message>
        <source>Its options are for another number of trajectories (%1) than it holds (%2): Cartographer may refuse to load it.</source>
        <translation>其选项针对的轨迹数（%1）与实际的轨迹数（%2）不同：Cartographer 可能拒绝加载它。</translation>
    </message>
    <message>
        <source>Format version</source>
        <translation>格式版本</translation>
    </message>
    <message>
        <source>Submaps</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>%1, %2 of them unfinished</source>
        <translation>%1，其中 %2 个未完成</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>Constraints</source>
        <translation>约束</translation>
    </message>
    <message>
        <source>%1 INTRA, %2 INTER, %3 dangling</source>
        <translation>%1 个 INTRA，%2 个 INTER，%3 个悬空</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>%1 m per cell</source>
        <translation>每栅格 %1 m</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>x %1 to %2 m, y %3 to %4 m</source>
        <translation>x %1 至 %2 m，y %3 至 %4 m</translation>
    </message>
    <message>
        <source>Trajectory %1</source>
        <translation>轨迹 %1</translation>
    </message>
    <message>
        <source>submaps: %1, nodes: %2, %3 m, %4 to %5</source>
        <translation>子图：%1，节点：%2，%3 m，%4 至 %5</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>The bag contains no constraints up to this time.</source>
        <translation>到该时间为止，数据包中没有约束。</translation>
    </message>
    <message>
        <source>The robot sent no constraints within %1 s (--timeout).</source>
        <translation>机器人在 %1 s 内没有发送约束 (--timeout)。</translation>
    </message>
    <message>
        <source>METRES</source>
        <translation>米</translation>
    </message>
    <message>
        <source>DEGREES</source>
        <translation>度</translation>
    </message>
    <message>
        <source>X INTRA</source>
        <translation>X INTRA</translation>
    </message>
    <message>
        <source>SUBMAP</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>NODE</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>LIES AT</source>
        <translation>实际位置</translation>
    </message>
    <message>
        <source>EXPECTED AT</source>
        <translation>期望位置</translation>
    </message>
    <message>
        <source>TIME (UTC)</source>
        <translation>时间 (UTC)</translation>
    </message>
    <message>
        <source>%1 more (--top 0 lists all).</source>
        <translation>还有 %1 行（--top 0 列出全部）。</translation>
    </message>
    <message>
        <source>%1 INTER (median %2), %3 INTRA (median %4), %5 dangling</source>
        <translation>%1 个 INTER（中位数 %2），%3 个 INTRA（中位数 %4），%5 个悬空</translation>
    </message>
    <message>
        <source>--min and --fail-over are metres, 0 or more.</source>
        <translation>--min 和 --fail-over 是米数，0 或更大。</translation>
    </message>
    <message>
        <source>--top is a number of rows; 0 lists all.</source>
        <translation>--top 是行数；0 列出全部。</translation>
    </message>
    <message>
        <source>This robot only draws its constraints: which submaps and nodes they connect, degrees, times, and whether any are dangling is not known.</source>
        <translation>该机器人只绘制其约束：它们连接哪些子图和节点、角度、时间以及是否有悬空的，都不得而知。</translation>
    </message>
    <message>
        <source>Constraints without a usable pose, which are not ranked: %1.</source>
        <translation>没有可用位姿、因而未参与排序的约束：%1。</translation>
    </message>
    <message>
        <source>Constraints that contradict the finished map by more than %2 m (--fail-over): %1, up to %3 m.</source>
        <translation>与最终地图矛盾超过 %2 m (--fail-over) 的约束：%1，最大 %3 m。</translation>
    </message>
    <message>
        <source>What a state file holds: trajectories, submaps, constraints</source>
        <translation>状态文件包含的内容：轨迹、子图、约束</translation>
    </message>
    <message>
        <source>Loop closures, those first that contradict the finished map most</source>
        <translation>回环，与最终地图矛盾最大的在前</translation>
    </message>
    <message>
        <source>State file (.pbstream) or robot address (or MAPWRIGHT_ROBOT)</source>
        <translation>状态文件 (.pbstream) 或机器人地址（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>Read recorded constraints: the name of a bag, or a file, with --at; FILE?ns=/NAMESPACE is one robot of several</source>
        <translation>读取录制的约束：数据包的名称或文件，配合 --at；FILE?ns=/NAMESPACE 表示多台机器人中的一台</translation>
    </message>
    <message>
        <source>inter (loop closures), intra or all</source>
        <translation>inter（回环）、intra 或 all</translation>
    </message>
    <message>
        <source>Only those of at least so many metres</source>
        <translation>只要不小于这么多米的</translation>
    </message>
    <message>
        <source>Only so many; 0: all (default: 20, with --json all)</source>
        <translation>只要这么多；0：全部（默认：20，使用 --json 时为全部）</translation>
    </message>
    <message>
        <source>Exit code 1 if one is larger than so many metres</source>
        <translation>有一个大于这么多米时退出码为 1</translation>
    </message>
    <message>
        <source>--region needs a robot that sends its map by region, and --mode grid.</source>
        <translation>--region 需要按分块发送地图的机器人，以及 --mode grid。</translation>
    </message>
    <message>
        <source>--region shows a part of the robot&apos;s own map and cannot be combined with --map.</source>
        <translation>--region 显示机器人自身地图的一部分，不能与 --map 同时使用。</translation>
    </message>
    <message>
        <source>A bag has no map by region: --region and --bag cannot be combined.</source>
        <translation>数据包没有分块地图：--region 和 --bag 不能同时使用。</translation>
    </message>
    <message>
        <source>--region already sets the view: it cannot be combined with --center, --fit and --rotate.</source>
        <translation>--region 已经设定了视图：不能与 --center、--fit 和 --rotate 同时使用。</translation>
    </message>
    <message>
        <source>With --region a pixel is one cell of the map, or as large as --scale says: --size cannot be set.</source>
        <translation>使用 --region 时，一个像素就是地图的一个栅格，或者如 --scale 所指定的大小：不能设置 --size。</translation>
    </message>
    <message>
        <source>--average only applies to whole maps, not to --region.</source>
        <translation>--average 只适用于整张地图，不适用于 --region。</translation>
    </message>
    <message>
        <source>--layers: &quot;%1&quot; has no choice of topic, only %2.</source>
        <translation>--layers：“%1”不能选择话题，只有 %2 可以。</translation>
    </message>
    <message>
        <source>--layers %1=: the topic is missing, for example %1=/topic.</source>
        <translation>--layers %1=：缺少话题，例如 %1=/topic。</translation>
    </message>
    <message>
        <source>--layers: there is no layer &quot;%1&quot;. Known: %2, or all, or none.</source>
        <translation>--layers：没有图层“%1”。已知：%2，或者 all 或 none。</translation>
    </message>
    <message>
        <source>--average only applies to whole maps: submaps are always averaged when zoomed out.</source>
        <translation>--average 只适用于整张地图：子图在缩小时总是取平均。</translation>
    </message>
    <message>
        <source>--slice only applies to submaps: a whole map has no slices.</source>
        <translation>--slice 只适用于子图：整张地图没有切片。</translation>
    </message>
    <message>
        <source>--colors %1 only applies to submaps, not to a whole map.</source>
        <translation>--colors %1 只适用于子图，不适用于整张地图。</translation>
    </message>
    <message>
        <source>--raw has no colours: it cannot be combined with --theme or --colors.</source>
        <translation>--raw 没有颜色：不能与 --theme 或 --colors 同时使用。</translation>
    </message>
    <message>
        <source>--raw draws only the map, without the layer &quot;%1&quot; of --layers.</source>
        <translation>--raw 只绘制地图，不能包含 --layers 的图层“%1”。</translation>
    </message>
    <message>
        <source>%1, which %2</source>
        <translation>%1，它%2</translation>
    </message>
    <message>
        <source>Layers, separated by commas: %1; or all (except %2); or none (only the map). NAME=TOPIC selects the topic for a grid, path or target of a ROS robot</source>
        <translation>图层，用逗号分隔：%1；或者 all（除了 %2）；或者 none（只有地图）。NAME=TOPIC 为 ROS 机器人的栅格、路径或目标选择话题</translation>
    </message>
    <message>
        <source>%1: regions of the map: %2 of %3</source>
        <translation>%1：地图分块：%2 / %3</translation>
    </message>
    <message>
        <source>%1: no map</source>
        <translation>%1：没有地图</translation>
    </message>
    <message>
        <source>%1: map %2%3, %4 x %5 cells</source>
        <translation>%1：地图 %2%3，%4 x %5 栅格</translation>
    </message>
    <message>
        <source>%1: %2 of %3 submaps</source>
        <translation>%1：子图 %2 / %3</translation>
    </message>
    <message>
        <source>, %1 missing</source>
        <translation>，%1 个缺失</translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation>，%1 个失败</translation>
    </message>
    <message>
        <source>, %1 corrupt</source>
        <translation>，%1 个损坏</translation>
    </message>
    <message>
        <source>, %1 without this slice</source>
        <translation>，%1 个没有该切片</translation>
    </message>
    <message>
        <source>Robot address, for example axbot+http://192.168.25.25:8090 or demo: (or MAPWRIGHT_ROBOT)</source>
        <translation>机器人地址，例如 axbot+http://192.168.25.25:8090 或 demo:（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>The PNG to write; - is the standard output</source>
        <translation>要写入的 PNG；- 表示标准输出</translation>
    </message>
    <message>
        <source>Overwrite a file even if the map was read from it</source>
        <translation>即使从某个文件读取了地图也覆盖它</translation>
    </message>
    <message>
        <source>submaps, or whole (or grid, the same for robots and files whose whole map is an occupancy grid). Default: submaps if there are any</source>
        <translation>submaps 或 whole（或 grid，对整张地图为占据栅格的机器人和文件来说相同）。默认：有子图时为 submaps</translation>
    </message>
    <message>
        <source>Id of a stored map, or mapping:ID (see mapwright maps list); by default the live or current one</source>
        <translation>已存地图的 id，或 mapping:ID（见 mapwright maps list）；默认为实时地图或当前地图</translation>
    </message>
    <message>
        <source>When zoomed out, show the average of the cells of a whole map; by default occupied cells win</source>
        <translation>缩小时显示整张地图各栅格的平均值；默认占据栅格优先</translation>
    </message>
    <message>
        <source>Draw the robot and its sensor data even on a map that it is not in</source>
        <translation>即使机器人不在该地图中，也绘制机器人及其传感器数据</translation>
    </message>
    <message>
        <source>Show the whole map (default without --center)</source>
        <translation>显示整张地图（没有 --center 时的默认）</translation>
    </message>
    <message>
        <source>A part of the map of a robot that sends its map by region (rep130+ws://): X,Y,LX,LY in metres, its centre and side lengths. A pixel is a cell, or as large as --scale says</source>
        <translation>按分块发送地图的机器人 (rep130+ws://) 的地图的一部分：X,Y,LX,LY，单位为米，即其中心和边长。一个像素就是一个栅格，或者如 --scale 所指定的大小</translation>
    </message>
    <message>
        <source>Position at the centre of the picture: X,Y in metres</source>
        <translation>图像中心的位置：X,Y，单位为米</translation>
    </message>
    <message>
        <source>Picture size: WIDTHxHEIGHT in pixels</source>
        <translation>图像大小：WIDTHxHEIGHT，单位为像素</translation>
    </message>
    <message>
        <source>Rotate the picture counter-clockwise by this many degrees</source>
        <translation>将图像逆时针旋转这么多度</translation>
    </message>
    <message>
        <source>Metres per pixel of a plain picture file</source>
        <translation>纯图像文件的每像素米数</translation>
    </message>
    <message>
        <source>Lower left corner of a plain picture file: X,Y or X,Y,YAW in metres and radians</source>
        <translation>纯图像文件的左下角：X,Y 或 X,Y,YAW，单位为米和弧度</translation>
    </message>
    <message>
        <source>Which slice of each submap to draw</source>
        <translation>绘制每个子图的哪个切片</translation>
    </message>
    <message>
        <source>normal, incremental, active, trajectory, age or version</source>
        <translation>normal、incremental、active、trajectory、age 或 version</translation>
    </message>
    <message>
        <source>light or dark</source>
        <translation>light 或 dark</translation>
    </message>
    <message>
        <source>Only the map pixels: gray = intensity, alpha 0 = not observed</source>
        <translation>只有地图像素：灰度 = 强度，alpha 0 = 未观测到</translation>
    </message>
    <message>
        <source>complete, or seconds to collect data</source>
        <translation>complete，或收集数据的秒数</translation>
    </message>
    <message>
        <source>Write a summary as JSON; - is the standard output</source>
        <translation>将摘要写为 JSON；- 表示标准输出</translation>
    </message>
    <message>
        <source>Print the report on standard output</source>
        <translation>在标准输出上输出报告</translation>
    </message>
    <message>
        <source>Draw recorded data: the name of a bag, or a file, with --at; FILE?ns=/NAMESPACE is one robot of several</source>
        <translation>绘制录制的数据：数据包的名称或文件，配合 --at；FILE?ns=/NAMESPACE 表示多台机器人中的一台</translation>
    </message>
    <message>
        <source>--bag NAME and --at TIME must be used together.</source>
        <translation>--bag NAME 和 --at TIME 必须一起使用。</translation>
    </message>
    <message>
        <source>--mode must be submaps, whole or grid, not &quot;%1&quot;.</source>
        <translation>--mode 必须是 submaps、whole 或 grid，不能是“%1”。</translation>
    </message>
    <message>
        <source>--map needs --mode whole: only the submaps of the robot&apos;s current SLAM session can be shown.</source>
        <translation>--map 需要 --mode whole：只能显示机器人当前 SLAM 会话的子图。</translation>
    </message>
    <message>
        <source>--size %1: give WIDTHxHEIGHT, for example 1920x1080, with at most %2 pixels per edge and %3 million in total.</source>
        <translation>--size %1：请给出 WIDTHxHEIGHT，例如 1920x1080，每边最多 %2 像素，总共最多 %3 百万像素。</translation>
    </message>
    <message>
        <source>--fit chooses centre and scale itself: it cannot be combined with --center and --scale.</source>
        <translation>--fit 会自行选择中心和比例：不能与 --center 和 --scale 同时使用。</translation>
    </message>
    <message>
        <source>--center X,Y and --scale METRES_PER_PIXEL must be used together.</source>
        <translation>--center X,Y 和 --scale METRES_PER_PIXEL 必须一起使用。</translation>
    </message>
    <message>
        <source>--center %1: give X,Y in metres, for example 12.5,-3, at most a million kilometres away.</source>
        <translation>--center %1：请给出 X,Y，单位为米，例如 12.5,-3，最远一百万公里。</translation>
    </message>
    <message>
        <source>--scale must be between %1 and %2 metres per pixel.</source>
        <translation>--scale 必须在每像素 %1 到 %2 米之间。</translation>
    </message>
    <message>
        <source>--rotate must be a number of degrees.</source>
        <translation>--rotate 必须是度数。</translation>
    </message>
    <message>
        <source>--slice must be 0 or more.</source>
        <translation>--slice 必须是 0 或更大。</translation>
    </message>
    <message>
        <source>--colors must be normal, incremental, active, trajectory, age or version, not &quot;%1&quot;.</source>
        <translation>--colors 必须是 normal、incremental、active、trajectory、age 或 version，不能是“%1”。</translation>
    </message>
    <message>
        <source>--theme must be light or dark, not &quot;%1&quot;.</source>
        <translation>--theme 必须是 light 或 dark，不能是“%1”。</translation>
    </message>
    <message>
        <source>--settle must be complete or a number of seconds, not &quot;%1&quot;.</source>
        <translation>--settle 必须是 complete 或秒数，不能是“%1”。</translation>
    </message>
    <message>
        <source>--settle %1 is longer than --timeout %2.</source>
        <translation>--settle %1 长于 --timeout %2。</translation>
    </message>
    <message>
        <source>%1: no connection was made in time.</source>
        <translation>%1：未能及时连接。</translation>
    </message>
    <message>
        <source>Draw a robot&apos;s map to a PNG, without a window</source>
        <translation>不打开窗口，将机器人的地图绘制为 PNG</translation>
    </message>
    <message>
        <source>It only sends its map as a whole.</source>
        <translation>它只发送整张地图。</translation>
    </message>
    <message>
        <source>It has no map in the plane, only a 3D map: pass --map projected_map_0 instead.</source>
        <translation>它没有平面地图，只有 3D 地图：请改用 --map projected_map_0。</translation>
    </message>
    <message>
        <source>%1: it does not offer its map by region. %2</source>
        <translation>%1：它不提供分块地图。%2</translation>
    </message>
    <message>
        <source>--region is too large for one picture: choose a coarser --scale.</source>
        <translation>--region 太大，无法绘成一张图像：请使用更粗的 --scale。</translation>
    </message>
    <message>
        <source>--region is too large: it has more cells than can be fetched for one picture.</source>
        <translation>--region 太大：栅格数超过一张图像所能获取的数量。</translation>
    </message>
    <message>
        <source>%1: no part of the region could be fetched. %2</source>
        <translation>%1：该区域的任何部分都无法获取。%2</translation>
    </message>
    <message>
        <source>%1: the map is empty in this region, so the size of its cells is unknown. Pass --scale to set the size of a pixel.</source>
        <translation>%1：地图在该区域中是空的，因此栅格大小未知。请用 --scale 设置像素的大小。</translation>
    </message>
    <message numerus="yes">
        <source>%1 cells in its answers are outside the range of -1 to 100. Values above 100 are shown as 100, values below -1 as unknown.</source>
        <translation>
            <numerusform>其应答中有 %1 个栅格超出 -1 到 100 的范围。大于 100 的值显示为 100，小于 -1 的值显示为未知。</numerusform>
        </translation>
    </message>
    <message>
        <source>Some of its answers are smaller than requested (%1 of %2): the missing parts are blank.</source>
        <translation>它的部分应答小于请求的大小（%1 / %2）：缺少的部分为空白。</translation>
    </message>
    <message>
        <source>Parts of the region are missing (%1 of %2 arrived). %3</source>
        <translation>该区域有部分缺失（到达 %1 / %2）。%3</translation>
    </message>
    <message>
        <source>Some of its answers have cells of another size or orientation and were left out.</source>
        <translation>它的部分应答的栅格大小或方向不同，已略去。</translation>
    </message>
    <message>
        <source>The robot is not in this map. Left out: %1. Pass --robot-anyway to draw them.</source>
        <translation>机器人不在该地图中。已略去：%1。要绘制它们，请使用 --robot-anyway。</translation>
    </message>
    <message>
        <source>The robot is not in this map. Drawn anyway: %1.</source>
        <translation>机器人不在该地图中。仍然绘制：%1。</translation>
    </message>
    <message>
        <source>The robot does not report which map it is in. It may not be this one: %1.</source>
        <translation>机器人没有上报它在哪张地图中。可能不是这一张：%1。</translation>
    </message>
    <message>
        <source>The connection to the robot was lost. %1</source>
        <translation>与机器人的连接已丢失。%1</translation>
    </message>
    <message>
        <source>%1 has no submaps: --slice and --colors only apply to those.</source>
        <translation>%1 没有子图：--slice 和 --colors 只适用于子图。</translation>
    </message>
    <message>
        <source>%1: its topics cannot be chosen (--layers NAME=TOPIC): this only works for ROS robots and their recordings.</source>
        <translation>%1：不能选择其话题 (--layers NAME=TOPIC)：只适用于 ROS 机器人及其录制文件。</translation>
    </message>
    <message>
        <source>The robot sent no readable submap list within %1 s: its whole map is drawn instead. Pass --mode submaps to wait longer.</source>
        <translation>机器人在 %1 s 内没有发送可读的子图列表：改为绘制其整张地图。要等待更久，请使用 --mode submaps。</translation>
    </message>
    <message>
        <source>The robot sent no submap list within %1 s: its whole map is drawn instead. Pass --mode submaps to wait longer.</source>
        <translation>机器人在 %1 s 内没有发送子图列表：改为绘制其整张地图。要等待更久，请使用 --mode submaps。</translation>
    </message>
    <message>
        <source>The bag contains no submap list up to this time: a whole map is drawn instead.</source>
        <translation>到该时间为止，数据包中没有子图列表：改为绘制整张地图。</translation>
    </message>
    <message>
        <source>The picture was not finished within %1 s (--timeout): parts of it are empty.</source>
        <translation>图像在 %1 s 内没有完成 (--timeout)：有部分是空的。</translation>
    </message>
    <message>
        <source>Not everything had arrived.</source>
        <translation>没有全部到达。</translation>
    </message>
    <message>
        <source>%1 The robot&apos;s sensor data is drawn without a map.</source>
        <translation>%1机器人的传感器数据在没有地图的情况下绘制。</translation>
    </message>
    <message>
        <source>Map %1: %2 % read</source>
        <translation>地图 %1：已读取 %2%</translation>
    </message>
    <message>
        <source>%1 of %2 submaps, %3 missing, %4 corrupt</source>
        <translation>%2 个子图中有 %1 个，%3 个缺失，%4 个损坏</translation>
    </message>
    <message>
        <source>Incomplete: no picture could be made within %1 s (--timeout).</source>
        <translation>不完整：在 %1 s 内未能生成图像 (--timeout)。</translation>
    </message>
    <message>
        <source>The robot sent an empty cloud of the map.</source>
        <translation>机器人发送的地图点云是空的。</translation>
    </message>
    <message>
        <source>The robot sent no readable submap list within %1 s (--timeout). Pass --mode whole to draw its whole map.</source>
        <translation>机器人在 %1 s 内没有发送可读的子图列表 (--timeout)。要绘制其整张地图，请使用 --mode whole。</translation>
    </message>
    <message>
        <source>The robot sent no submap list within %1 s (--timeout). Pass --mode whole to draw its whole map.</source>
        <translation>机器人在 %1 s 内没有发送子图列表 (--timeout)。要绘制其整张地图，请使用 --mode whole。</translation>
    </message>
    <message>
        <source>map %1</source>
        <translation>地图 %1</translation>
    </message>
    <message>
        <source>its map</source>
        <translation>其地图</translation>
    </message>
    <message>
        <source>%1: %2 had not arrived within %3 s (%4). There is nothing to draw.</source>
        <translation>%1：%2 在 %3 s 内没有到达（%4）。没有可绘制的内容。</translation>
    </message>
    <message>
        <source>Loop closures are not drawn.</source>
        <translation>未绘制回环。</translation>
    </message>
    <message>
        <source>Loop closures are not drawn: the pose graph was not read.</source>
        <translation>未绘制回环：没有读取位姿图。</translation>
    </message>
    <message>
        <source>The bag contains no map up to this time: the one recorded with it is drawn.</source>
        <translation>到该时间为止，数据包中没有地图：绘制的是随之录制的地图。</translation>
    </message>
    <message>
        <source>The bag contains no map up to this time: the robot&apos;s present map is drawn.</source>
        <translation>到该时间为止，数据包中没有地图：绘制的是机器人现在的地图。</translation>
    </message>
    <message>
        <source>The bag contains no submap list up to this time: there are no submaps to draw.</source>
        <translation>到该时间为止，数据包中没有子图列表：没有可绘制的子图。</translation>
    </message>
    <message>
        <source>Nothing arrived on topic %1 within %2 s.</source>
        <translation>话题 %1 在 %2 s 内没有收到任何内容。</translation>
    </message>
    <message>
        <source>Layer %1 is empty: the bag has no topic for it.</source>
        <translation>图层 %1 是空的：数据包中没有对应的话题。</translation>
    </message>
    <message>
        <source>Layer %1 is empty: the robot has no topic for it.</source>
        <translation>图层 %1 是空的：机器人没有对应的话题。</translation>
    </message>
    <message>
        <source>Layer %1 is empty: it is about submaps, and a whole map is drawn (--mode submaps).</source>
        <translation>图层 %1 是空的：它与子图有关，而绘制的是整张地图 (--mode submaps)。</translation>
    </message>
    <message>
        <source>No submap has a slice %1 (--slice): the picture is empty.</source>
        <translation>没有子图具有切片 %1 (--slice)：图像是空的。</translation>
    </message>
    <message numerus="yes">
        <source>%1 markers of %2 are missing: the transforms that place them had not arrived.</source>
        <translation>
            <numerusform>%2 的 %1 个标记缺失：用于放置它们的变换没有到达。</numerusform>
        </translation>
    </message>
    <message>
        <source>Topic %1 does not exist or its type does not fit the layer. Topics that fit: %2.</source>
        <translation>话题 %1 不存在，或其类型不适合该图层。适合的话题：%2。</translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps could not be read back from the disk: parts of the picture are empty.</source>
        <translation>
            <numerusform>%1 个子图无法从磁盘读回：图像有部分是空的。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>无法读取 %1：%2</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>无法写入文件夹 %1。</translation>
    </message>
    <message>
        <source>%1: no view of this suite makes this picture. Delete it, or restore its view.</source>
        <translation>%1：该套件中没有视图会生成此图像。请删除它，或恢复其视图。</translation>
    </message>
    <message>
        <source>--only: there is no view &quot;%1&quot; in %2.</source>
        <translation>--only：%2 中没有视图“%1”。</translation>
    </message>
    <message>
        <source>--expected and --report are the same folder. Choose two different ones.</source>
        <translation>--expected 和 --report 是同一个文件夹。请使用两个不同的文件夹。</translation>
    </message>
    <message>
        <source>%1: there is no mask %2.</source>
        <translation>%1：没有遮罩 %2。</translation>
    </message>
    <message>
        <source>There is no expected picture %1. mapwright suite accept makes one.</source>
        <translation>没有期望图像 %1。可用 mapwright suite accept 生成。</translation>
    </message>
    <message>
        <source>%1 of %2 views</source>
        <translation>视图 %1 / %2</translation>
    </message>
    <message>
        <source>No longer accepted: %1. </source>
        <translation>不再接受：%1。</translation>
    </message>
    <message>
        <source>%1: nothing accepted. %2</source>
        <translation>%1：未接受任何内容。%2</translation>
    </message>
    <message>
        <source>%1: as expected, nothing is replaced</source>
        <translation>%1：符合期望，未替换任何内容</translation>
    </message>
    <message>
        <source>%1: as expected, the facts beside it are new: %2</source>
        <translation>%1：符合期望，其附带的信息是新的：%2</translation>
    </message>
    <message>
        <source>%1: new, %2</source>
        <translation>%1：新建，%2</translation>
    </message>
    <message>
        <source>%1: replaced %2</source>
        <translation>%1：已替换 %2</translation>
    </message>
    <message>
        <source>not expected yet</source>
        <translation>尚无期望图像</translation>
    </message>
    <message numerus="yes">
        <source>%1 accepted pictures</source>
        <translation>
            <numerusform>%1 张已接受的图像</numerusform>
        </translation>
    </message>
    <message>
        <source>Expected pictures are accepted by people: accept does nothing where the variable CI is set.</source>
        <translation>期望图像须由人来接受：设置了变量 CI 时，accept 不起作用。</translation>
    </message>
    <message>
        <source>--jobs must be a number from 1 to %1.</source>
        <translation>--jobs 必须是 1 到 %1 的数字。</translation>
    </message>
    <message>
        <source>Compare many views with their expected pictures</source>
        <translation>将多个视图与其期望图像比较</translation>
    </message>
    <message>
        <source>Draw all views, compare them, write junit.xml and report.html</source>
        <translation>绘制并比较所有视图，写出 junit.xml 和 report.html</translation>
    </message>
    <message>
        <source>Draw all views and store them as the expected pictures</source>
        <translation>绘制所有视图，并将其存为期望图像</translation>
    </message>
    <message>
        <source>List the views and their expected pictures</source>
        <translation>列出各视图及其期望图像</translation>
    </message>
    <message>
        <source>The list of views (YAML)</source>
        <translation>视图列表 (YAML)</translation>
    </message>
    <message>
        <source>Folder with the expected pictures and their facts</source>
        <translation>存放期望图像及其附带信息的文件夹</translation>
    </message>
    <message>
        <source>Folder for the report and the pictures that differ</source>
        <translation>存放报告和有差异的图像的文件夹</translation>
    </message>
    <message>
        <source>Only this view; may be repeated</source>
        <translation>只要该视图；可重复使用</translation>
    </message>
    <message>
        <source>Number of views drawn at the same time</source>
        <translation>同时绘制的视图数</translation>
    </message>
    <message>
        <source>Robot for views that name none (or MAPWRIGHT_ROBOT)</source>
        <translation>未指定机器人的视图所用的机器人（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>A view of a recording needs &quot;at&quot;, the time in it: %1.</source>
        <translation>录制文件的视图需要“at”，即其中的时间：%1。</translation>
    </message>
    <message>
        <source>It names no robot, and neither does --robot.</source>
        <translation>它没有指定机器人，--robot 也没有。</translation>
    </message>
    <message>
        <source>Loop closures could not be judged: the pose graph was not read.</source>
        <translation>无法评判回环：没有读取位姿图。</translation>
    </message>
    <message>
        <source>Loop closures could not be judged.</source>
        <translation>无法评判回环。</translation>
    </message>
    <message>
        <source>Whether submaps contradict each other could not be judged: %1</source>
        <translation>无法评判子图是否相互矛盾：%1</translation>
    </message>
    <message>
        <source>there is no list of submaps here.</source>
        <translation>这里没有子图列表。</translation>
    </message>
    <message>
        <source>%1 of %2 submaps are here.</source>
        <translation>%2 个子图中只有 %1 个。</translation>
    </message>
    <message>
        <source>there are no submaps.</source>
        <translation>没有子图。</translation>
    </message>
    <message>
        <source>submap %1 lies too far away.</source>
        <translation>子图 %1 太远。</translation>
    </message>
    <message>
        <source>some could not be read back from the disk.</source>
        <translation>有些无法从磁盘读回。</translation>
    </message>
    <message>
        <source>comparing them took longer than %1 s.</source>
        <translation>比较用时超过 %1 s。</translation>
    </message>
    <message>
        <source>The robot does not list its topics (its node rosapi is not running): these are the usual ones.</source>
        <translation>机器人没有列出话题（其节点 rosapi 没有运行）：以下是常见的话题。</translation>
    </message>
    <message>
        <source>The robot does not list its topics: these are the ones that mapwright understands.</source>
        <translation>机器人没有列出话题：以下是 mapwright 能理解的话题。</translation>
    </message>
    <message>
        <source>Long lists and texts are shortened (--shorten).</source>
        <translation>长列表和长文本已截短 (--shorten)。</translation>
    </message>
    <message>
        <source>%1: nothing arrived within %2 s (--timeout).</source>
        <translation>%1：%2 s 内没有收到任何内容 (--timeout)。</translation>
    </message>
    <message>
        <source>LAYERS</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>PER SECOND</source>
        <translation>每秒</translation>
    </message>
    <message>
        <source>MIN (s)</source>
        <translation>最小 (s)</translation>
    </message>
    <message>
        <source>MAX (s)</source>
        <translation>最大 (s)</translation>
    </message>
    <message>
        <source>STD DEV (s)</source>
        <translation>标准差 (s)</translation>
    </message>
    <message>
        <source>BYTES/s</source>
        <translation>字节/s</translation>
    </message>
    <message>
        <source>%1: nothing arrived within %2 s (--seconds).</source>
        <translation>%1：%2 s 内没有收到任何内容 (--seconds)。</translation>
    </message>
    <message>
        <source>%1: only one message arrived within %2 s (--seconds), too few for a rate.</source>
        <translation>%1：%2 s 内只收到一条消息 (--seconds)，不足以计算频率。</translation>
    </message>
    <message>
        <source>--seconds must be greater than 0 and at most 86400.</source>
        <translation>--seconds 必须大于 0 且不超过 86400。</translation>
    </message>
    <message>
        <source>%1 sends nothing by itself. For a recording, mapwright bags frames prints the messages and mapwright bags info shows what it contains.</source>
        <translation>%1 自身不发送任何内容。对于录制文件，mapwright bags frames 输出消息，mapwright bags info 显示其内容。</translation>
    </message>
    <message>
        <source>The topics of a robot: list, echo, hz</source>
        <translation>机器人的话题：list、echo、hz</translation>
    </message>
    <message>
        <source>Robot address, or a recording for list (or MAPWRIGHT_ROBOT)</source>
        <translation>机器人地址，list 也可用录制文件（或 MAPWRIGHT_ROBOT）</translation>
    </message>
    <message>
        <source>List all topics with their types</source>
        <translation>列出所有话题及其类型</translation>
    </message>
    <message>
        <source>Print the messages of a topic as they arrive, one JSON text per line, until Ctrl+C</source>
        <translation>实时输出话题的消息，每行一个 JSON 文本，直到按下 Ctrl+C</translation>
    </message>
    <message>
        <source>Topic, as the robot names it</source>
        <translation>话题，使用机器人上的名称</translation>
    </message>
    <message>
        <source>Stop after this many messages; by default at Ctrl+C</source>
        <translation>收到这么多消息后停止；默认到按下 Ctrl+C 为止</translation>
    </message>
    <message>
        <source>Print only the beginning of long lists and texts, still as JSON</source>
        <translation>长列表和长文本只输出开头部分，仍为 JSON</translation>
    </message>
    <message>
        <source>Timeout in seconds without a connection or a message</source>
        <translation>没有连接或消息时的超时，单位为秒</translation>
    </message>
    <message>
        <source>Measure the rates of topics and how regular they are</source>
        <translation>测量话题的频率及其规律性</translation>
    </message>
    <message>
        <source>Topics, as the robot names them</source>
        <translation>话题，使用机器人上的名称</translation>
    </message>
    <message>
        <source>For how many seconds to measure</source>
        <translation>测量多少秒</translation>
    </message>
    <message>
        <source>%1 Did you mean %2?</source>
        <translation>%1您是不是想用 %2？</translation>
    </message>
    <message>
        <source>%1: no such option of %2.</source>
        <translation>%1：%2 没有这个选项。</translation>
    </message>
    <message>
        <source>%1: no such subcommand of %2.</source>
        <translation>%1：%2 没有这个子命令。</translation>
    </message>
    <message>
        <source>%1: one word too many for %2. Quote a name that has blanks in it.</source>
        <translation>%1：对 %2 来说多了一个词。含有空格的名称请加引号。</translation>
    </message>
    <message>
        <source>%1 needs a subcommand: %2.</source>
        <translation>%1 需要子命令：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; looks like a temporary name left by an interrupted swap of names. It was called &quot;%2&quot; before. Apply the plan again, or rename it.</source>
        <translation>“%1”像是名称互换中断后留下的临时名称。它之前叫“%2”。请再次应用方案，或将其重命名。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; looks like a temporary name left by an interrupted swap of names. Another waypoint is called &quot;%2&quot; now. Apply the plan again, or rename it.</source>
        <translation>“%1”像是名称互换中断后留下的临时名称。现在另一个路径点叫“%2”。请再次应用方案，或将其重命名。</translation>
    </message>
    <message>
        <source>There is no waypoint %1 (see mapwright waypoints list).</source>
        <translation>没有路径点 %1（见 mapwright waypoints list）。</translation>
    </message>
    <message>
        <source>Several waypoints are called &quot;%1&quot;. Pass an id: %2.</source>
        <translation>有多个路径点叫“%1”。请给出 id：%2。</translation>
    </message>
    <message>
        <source>--format %1: must be csv or geojson.</source>
        <translation>--format %1：必须是 csv 或 geojson。</translation>
    </message>
    <message>
        <source>%1: the name must end in .geojson or .csv; or pass --format geojson or csv.</source>
        <translation>%1：文件名必须以 .geojson 或 .csv 结尾；或者使用 --format geojson 或 csv。</translation>
    </message>
    <message>
        <source>--angles %1: must be degrees or radians.</source>
        <translation>--angles %1：必须是 degrees 或 radians。</translation>
    </message>
    <message>
        <source>--format %1: must be csv, geojson or yaml.</source>
        <translation>--format %1：必须是 csv、geojson 或 yaml。</translation>
    </message>
    <message>
        <source>%1: the name must end in .geojson, .json, .csv or .yaml; or pass --format geojson, csv or yaml.</source>
        <translation>%1：文件名必须以 .geojson、.json、.csv 或 .yaml 结尾；或者使用 --format geojson、csv 或 yaml。</translation>
    </message>
    <message>
        <source>%1 is larger than 64 MiB.</source>
        <translation>%1 大于 64 MiB。</translation>
    </message>
    <message>
        <source>Pass --angles degrees or --angles radians to be sure.</source>
        <translation>为确保无误，请使用 --angles degrees 或 --angles radians。</translation>
    </message>
    <message>
        <source>The map under the waypoints cannot be read, so they are not checked for walls.</source>
        <translation>无法读取路径点所在的地图，因此未检查路径点是否在墙中。</translation>
    </message>
    <message>
        <source>NEW VALUE</source>
        <translation>新值</translation>
    </message>
    <message>
        <source>conflict</source>
        <translation>冲突</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>There is nothing to change.</source>
        <translation>没有需要更改的内容。</translation>
    </message>
    <message>
        <source>applied</source>
        <translation>已应用</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>not sent</source>
        <translation>未下发</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is temporarily called &quot;%2&quot;, until the name &quot;%3&quot; is free.</source>
        <translation>“%1”临时叫“%2”，直到名称“%3”空出来。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; may temporarily be called &quot;%2&quot;, until the name &quot;%3&quot; is free.</source>
        <translation>“%1”可能临时叫“%2”，直到名称“%3”空出来。</translation>
    </message>
    <message>
        <source>Run the command again to finish it.</source>
        <translation>请再次运行该命令以完成。</translation>
    </message>
    <message>
        <source>%1 (and %2 more)</source>
        <translation>%1（还有 %2 个）</translation>
    </message>
    <message>
        <source>The waypoints have been changed by someone else in the meantime, in a way that conflicts with this: %1. %2</source>
        <translation>路径点在此期间已被他人修改，与此次更改冲突：%1。%2</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>没有下发任何内容。</translation>
    </message>
    <message>
        <source>The rest was not sent.</source>
        <translation>其余部分未下发。</translation>
    </message>
    <message>
        <source>Of %1 changes: %2 applied, %3 failed, %4 with unknown result, %5 not sent. %6</source>
        <translation>共 %1 项更改：%2 项已应用，%3 项失败，%4 项结果未知，%5 项未下发。%6</translation>
    </message>
    <message>
        <source>STATE</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>temporary name</source>
        <translation>临时名称</translation>
    </message>
    <message>
        <source>There are no waypoints.</source>
        <translation>没有路径点。</translation>
    </message>
    <message>
        <source>TAGS</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>WARNINGS</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>type</source>
        <translation>类型</translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints</source>
        <translation>
            <numerusform>%1 个路径点</numerusform>
        </translation>
    </message>
    <message>
        <source>--at %1: give X,Y in metres, or X,Y,YAW with the yaw in degrees, for example 1.5,-2,90.</source>
        <translation>--at %1：请给出 X,Y，单位为米，或 X,Y,YAW，其中朝向单位为度，例如 1.5,-2,90。</translation>
    </message>
    <message>
        <source>%1 %2: give tags as a,b (%3)</source>
        <translation>%1 %2：请以 a,b 的形式给出标签（%3）</translation>
    </message>
    <message>
        <source>Waypoints of this robot cannot have tags.</source>
        <translation>该机器人的路径点不能有标签。</translation>
    </message>
    <message>
        <source>Which tags? Pass --set a,b, or --clear, or --add and --remove.</source>
        <translation>哪些标签？请使用 --set a,b，或 --clear，或 --add 和 --remove。</translation>
    </message>
    <message>
        <source>The tag %1 cannot be both added and removed.</source>
        <translation>标签 %1 不能既添加又移除。</translation>
    </message>
    <message>
        <source>Deleting waypoints cannot be undone. Pass --yes to delete them.</source>
        <translation>删除路径点后无法撤销。要删除，请使用 --yes。</translation>
    </message>
    <message>
        <source>%1 was made for the map %2 of %3. Pass --force to apply it to the map %4 of %5.</source>
        <translation>%1 是为 %3 的地图 %2 制作的。要应用到 %5 的地图 %4，请使用 --force。</translation>
    </message>
    <message>
        <source>%1 deletes %2 of the %3 waypoints of the map %4. Pass --yes to apply it.</source>
        <translation>%1 会删除地图 %4 的 %3 个路径点中的 %2 个。要应用，请使用 --yes。</translation>
    </message>
    <message>
        <source>List the waypoints of a map</source>
        <translation>列出地图的路径点</translation>
    </message>
    <message>
        <source>Show one waypoint</source>
        <translation>显示一个路径点</translation>
    </message>
    <message>
        <source>Add a waypoint</source>
        <translation>添加路径点</translation>
    </message>
    <message>
        <source>Rename a waypoint</source>
        <translation>重命名路径点</translation>
    </message>
    <message>
        <source>Move or turn a waypoint</source>
        <translation>移动或旋转路径点</translation>
    </message>
    <message>
        <source>Change the tags of a waypoint</source>
        <translation>更改路径点的标签</translation>
    </message>
    <message>
        <source>Delete waypoints (--yes)</source>
        <translation>删除路径点 (--yes)</translation>
    </message>
    <message>
        <source>Add and update the waypoints listed in a file; others stay</source>
        <translation>添加和更新文件中列出的路径点；其他的不变</translation>
    </message>
    <message>
        <source>Write all waypoints of a map as GeoJSON or CSV</source>
        <translation>将地图的所有路径点写为 GeoJSON 或 CSV</translation>
    </message>
    <message>
        <source>Work out the changes that make the waypoints match a file; sends nothing</source>
        <translation>计算使路径点与文件一致所需的更改；不下发</translation>
    </message>
    <message>
        <source>Carry out a plan, merged with changes that others have made since</source>
        <translation>执行方案，并与他人此后所做的修改合并</translation>
    </message>
    <message>
        <source>Its id, or its name if no other waypoint has it</source>
        <translation>其 id；没有其他路径点同名时也可用名称</translation>
    </message>
    <message>
        <source>Their ids, or names</source>
        <translation>它们的 id 或名称</translation>
    </message>
    <message>
        <source>X,Y or X,Y,YAW in metres of the map and degrees, counter-clockwise</source>
        <translation>X,Y 或 X,Y,YAW，单位为地图的米和度，逆时针</translation>
    </message>
    <message>
        <source>Tags: a,b</source>
        <translation>标签：a,b</translation>
    </message>
    <message>
        <source>Exactly these tags: a,b</source>
        <translation>恰好这些标签：a,b</translation>
    </message>
    <message>
        <source>Add these tags: a,b</source>
        <translation>添加这些标签：a,b</translation>
    </message>
    <message>
        <source>Remove these tags: a,b</source>
        <translation>移除这些标签：a,b</translation>
    </message>
    <message>
        <source>Remove all tags</source>
        <translation>移除所有标签</translation>
    </message>
    <message>
        <source>Even if more waypoints are deleted than kept</source>
        <translation>即使删除的路径点多于保留的也执行</translation>
    </message>
    <message>
        <source>F.geojson, F.csv or F.yaml: a list of places or poses; - is the standard input</source>
        <translation>F.geojson、F.csv 或 F.yaml：位置或位姿的列表；- 表示标准输入</translation>
    </message>
    <message>
        <source>The output of mapwright waypoints plan -o; - is the standard input</source>
        <translation>mapwright waypoints plan -o 的输出；- 表示标准输入</translation>
    </message>
    <message>
        <source>F.geojson or F.csv; - is the standard output</source>
        <translation>F.geojson 或 F.csv；- 表示标准输出</translation>
    </message>
    <message>
        <source>Where to write the plan for mapwright waypoints apply; - is the standard output</source>
        <translation>供 mapwright waypoints apply 使用的方案写到哪里；- 表示标准输出</translation>
    </message>
    <message>
        <source>Also show possible mistakes: in a wall, outside the map, near a wall, duplicate name, zero quaternion</source>
        <translation>同时显示可能的错误：在墙中、在地图外、靠近墙、名称重复、零四元数</translation>
    </message>
    <message>
        <source>Warn of walls that are closer than this, in metres; by default taken from the robot&apos;s footprint</source>
        <translation>墙比该距离更近时警告，单位为米；默认由机器人外形得出</translation>
    </message>
    <message>
        <source>csv or geojson, if the file name does not say</source>
        <translation>csv 或 geojson（文件名未说明时）</translation>
    </message>
    <message>
        <source>csv, geojson or yaml, if the file name does not say</source>
        <translation>csv、geojson 或 yaml（文件名未说明时）</translation>
    </message>
    <message>
        <source>degrees or radians, for headings whose name has no unit; by default radians unless one is more than a full turn</source>
        <translation>degrees 或 radians，用于名称中没有单位的朝向；默认为 radians，除非有一个超过一整圈</translation>
    </message>
    <message>
        <source>Apply it even to a map that the plan was not made for</source>
        <translation>即使方案不是为该地图制作的也应用</translation>
    </message>
    <message>
        <source>Stop after the first request that fails (default)</source>
        <translation>在第一个失败的请求之后停止（默认）</translation>
    </message>
    <message>
        <source>Send the remaining ones anyway, unless the connection is lost</source>
        <translation>仍然发送其余的请求，除非连接丢失</translation>
    </message>
    <message>
        <source>Print the changes without sending anything</source>
        <translation>输出更改，不下发任何内容</translation>
    </message>
    <message>
        <source>The waypoints of a map: list, change, import, export, plan, apply</source>
        <translation>地图的路径点：列出、更改、导入、导出、制作方案、应用方案</translation>
    </message>
    <message>
        <source>Id of a stored map (see mapwright maps list); by default the current one</source>
        <translation>已存地图的 id（见 mapwright maps list）；默认为当前地图</translation>
    </message>
    <message>
        <source>Print this help message and exit</source>
        <translation>显示此帮助并退出</translation>
    </message>
    <message>
        <source>Language of all texts; without it the window has the one chosen in it, and commands speak English</source>
        <translation>所有文字的语言；不指定时，窗口使用其中所选的语言，命令使用英语</translation>
    </message>
    <message>
        <source>Usage</source>
        <translation>用法</translation>
    </message>
    <message>
        <source>Positionals</source>
        <translation>位置参数</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Subcommands</source>
        <translation>子命令</translation>
    </message>
    <message>
        <source>--language %1: there is no such language. There are %2.</source>
        <translation>--language %1：没有该语言。可用的有 %2。</translation>
    </message>
    <message>
        <source>No font here has Chinese characters, so the window is in English. Install one, such as fonts-noto-cjk.</source>
        <translation>这里没有含中文字符的字体，因此窗口使用英语。请安装一种，例如 fonts-noto-cjk。</translation>
    </message>
    <message>
        <source>Submaps have no waypoints and no overlays of their own. Pass the map that they were placed on as --from.</source>
        <translation>子图没有自己的路径点和覆盖物。请用 --from 指定放置它们时所用的地图。</translation>
    </message>
    <message>
        <source>Boxes (bbox) left out because they did not fit their overlay: %1.</source>
        <translation>以下边界框 (bbox) 与其覆盖物不符，已略去：%1。</translation>
    </message>
    <message>
        <source>The box (bbox) of the new map&apos;s overlays did not fit them, and stays as it is.</source>
        <translation>新地图覆盖物的边界框 (bbox) 与它们不符，保持原样。</translation>
    </message>
    <message>
        <source>Print the version and exit</source>
        <translation>显示版本并退出</translation>
    </message>
    <message>
        <source>Print version, commit and libraries with their licences as JSON (with --version)</source>
        <translation>以 JSON 显示版本、提交号，以及各库及其许可证（与 --version 一起使用）</translation>
    </message>
    <message>
        <source>Log to this file instead, and everything where there is no --log; at 2 MB it becomes FILE.1, and so on to FILE.4</source>
        <translation>改为把日志写入此文件；没有 --log 时记录全部内容；达到 2 MB 时改名为 FILE.1，依此类推到 FILE.4</translation>
    </message>
    <message>
        <source>There is no log in %1: %2</source>
        <translation>%1 中没有日志：%2</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>it is no file.</source>
        <translation>它不是文件。</translation>
    </message>
    <message>
        <source>another mapwright is writing there.</source>
        <translation>另一个 mapwright 正在写入。</translation>
    </message>
    <message>
        <source>the file is something else.</source>
        <translation>该文件是别的内容。</translation>
    </message>
    <message>
        <source>%1 beside it is something else.</source>
        <translation>旁边的 %1 是别的内容。</translation>
    </message>
    <message>
        <source>The log in %1 lacks lines: %2.</source>
        <translation>%1 中的日志缺少一些行：%2。</translation>
    </message>
    <message>
        <source>X,Y,YAW in metres and degrees, from the old map to the new one, instead of aligning them as maps align does</source>
        <translation>X,Y,YAW，单位为米和度，从旧地图到新地图；不再像 maps align 那样自动对齐</translation>
    </message>
    <message>
        <source>Radius of the robot in metres (default: as it reports, else 0.3); 0: as if it had no size</source>
        <translation>机器人半径，单位米（默认：取机器人报告的值，否则为 0.3）；0：视为没有大小</translation>
    </message>
    <message>
        <source>%1: there is no line of it to look at.</source>
        <translation>%1：其中没有可查看的路线。</translation>
    </message>
    <message>
        <source>There is no folder for temporary files: %1. Set TMPDIR, or pass --report.</source>
        <translation>没有存放临时文件的文件夹：%1。请设置 TMPDIR，或使用 --report。</translation>
    </message>
    <message>
        <source>%1 is required</source>
        <translation>缺少 %1</translation>
    </message>
    <message>
        <source>%1 needs a value</source>
        <translation>%1 需要一个值</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 需要 %2</translation>
    </message>
    <message>
        <source>%1 is given more than once</source>
        <translation>%1 给出了不止一次</translation>
    </message>
    <message>
        <source>%1 is given %2 values: at most %3</source>
        <translation>%1 给出了 %2 个值：最多 %3 个</translation>
    </message>
    <message>
        <source>%1 is given %2 values: at least %3</source>
        <translation>%1 给出了 %2 个值：至少 %3 个</translation>
    </message>
    <message>
        <source>%1 goes only with %2</source>
        <translation>%1 只能与 %2 一起使用</translation>
    </message>
    <message>
        <source>%1 does not go with %2</source>
        <translation>%1 不能与 %2 一起使用</translation>
    </message>
    <message>
        <source>%1: %2 is not a number that fits</source>
        <translation>%1：%2 不是合适的数字</translation>
    </message>
    <message>
        <source>%1: %2 is not between %3 and %4</source>
        <translation>%1：%2 不在 %3 到 %4 之间</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation>%1：“%2”不是数字</translation>
    </message>
    <message>
        <source>%1: %2 is not one of %3</source>
        <translation>%1：%2 不是以下之一：%3</translation>
    </message>
    <message>
        <source>%1 is not in UTF-8, and a file of that name cannot be opened. Rename it, for example with convmv.</source>
        <translation>%1 不是 UTF-8 编码，无法打开这个名称的文件。请将它重命名，例如使用 convmv。</translation>
    </message>
    <message>
        <source>%1 is given more than once.</source>
        <translation>%1 给出了不止一次。</translation>
    </message>
    <message>
        <source>%1 has no effect beside --version, which only prints the version.</source>
        <translation>%1 与 --version 一起使用时不起作用，后者只输出版本。</translation>
    </message>
    <message>
        <source>--log-file needs the name of a file. Without it, --log all writes to standard error.</source>
        <translation>--log-file 需要一个文件名。不用它时，--log all 会写到标准错误。</translation>
    </message>
    <message>
        <source>Walls and reachability were not checked. %1</source>
        <translation>未检查墙和可达性。%1</translation>
    </message>
    <message>
        <source>%1 is an address: put --robot in front of it.</source>
        <translation>%1 是地址：请在它前面加上 --robot。</translation>
    </message>
    <message>
        <source>%1: no connection within %2 s.</source>
        <translation>%1：%2 s 内没有建立连接。</translation>
    </message>
    <message>
        <source>REQUIRED</source>
        <translation>必需</translation>
    </message>
    <message>
        <source>Env</source>
        <translation>环境变量</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>需要</translation>
    </message>
    <message>
        <source>Excludes</source>
        <translation>不可同时使用</translation>
    </message>
    <message>
        <source>, %1 not there in time</source>
        <translation>，%1 个未及时到达</translation>
    </message>
</context>
<context>
    <name>ComparisonText</name>
    <message numerus="yes">
        <source>%1 pixels</source>
        <translation>
            <numerusform>%1 像素</numerusform>
        </translation>
    </message>
    <message>
        <source>The sizes differ: %1 expected, %2 here.</source>
        <translation>大小不同：期望 %1，此处 %2。</translation>
    </message>
    <message>
        <source>1 cluster of %1 at %2</source>
        <translation>1 个聚簇，%1，位于 %2</translation>
    </message>
    <message>
        <source>1 cluster of %1 at pixel %2</source>
        <translation>1 个聚簇，%1，位于像素 %2</translation>
    </message>
    <message>
        <source>%1 clusters, the largest %2 at %3</source>
        <translation>%1 个聚簇，最大的为 %2，位于 %3</translation>
    </message>
    <message>
        <source>%1 clusters, the largest %2 at pixel %3</source>
        <translation>%1 个聚簇，最大的为 %2，位于像素 %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels differ</source>
        <translation>
            <numerusform>%1 个像素不同</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2 %), by up to %3</source>
        <translation>%1（%2%），最大相差 %3</translation>
    </message>
    <message>
        <source>The pictures are the same.</source>
        <translation>两张图像相同。</translation>
    </message>
    <message>
        <source>The pictures are equal: no channel differs by more than is allowed (%1 at most).</source>
        <translation>两张图像一致：没有通道的差异超过允许值（最大 %1）。</translation>
    </message>
    <message>
        <source>That is allowed.</source>
        <translation>这是允许的。</translation>
    </message>
</context>
<context>
    <name>FactsChanges</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 以及另外 %2 项</translation>
    </message>
    <message>
        <source>moved by %1 m and turned by %2°</source>
        <translation>移动了 %1 m，旋转了 %2°</translation>
    </message>
    <message>
        <source>moved by %1 m</source>
        <translation>移动了 %1 m</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>旋转了 %1°</translation>
    </message>
    <message>
        <source>the view is another one</source>
        <translation>视图变成了另一个</translation>
    </message>
    <message>
        <source>the theme is %1 instead of %2</source>
        <translation>主题由 %2 变为 %1</translation>
    </message>
    <message>
        <source>layers that are drawn now: %1</source>
        <translation>现在绘制的图层：%1</translation>
    </message>
    <message>
        <source>layers that are drawn no more: %1</source>
        <translation>不再绘制的图层：%1</translation>
    </message>
    <message>
        <source>map %1 has another resolution</source>
        <translation>地图 %1 的分辨率变了</translation>
    </message>
    <message>
        <source>map %1 lies %2 m elsewhere</source>
        <translation>地图 %1 的位置偏移了 %2 m</translation>
    </message>
    <message>
        <source>map %1 is turned by %2°</source>
        <translation>地图 %1 旋转了 %2°</translation>
    </message>
    <message>
        <source>it is map %1 instead of %2</source>
        <translation>地图由 %2 变为 %1</translation>
    </message>
    <message>
        <source>map %1 went from version %2 to %3</source>
        <translation>地图 %1 由版本 %2 变为 %3</translation>
    </message>
    <message>
        <source>cells of map %1 changed within %2 x %3 m at %4</source>
        <translation>地图 %1 的栅格有变化，范围 %2 x %3 m，位于 %4</translation>
    </message>
    <message>
        <source>the cells of map %1 changed</source>
        <translation>地图 %1 的栅格有变化</translation>
    </message>
    <message>
        <source>it is another SLAM session</source>
        <translation>SLAM 会话变成了另一个</translation>
    </message>
    <message>
        <source>submap %1 is gone</source>
        <translation>子图 %1 已消失</translation>
    </message>
    <message>
        <source>went from version %1 to %2</source>
        <translation>由版本 %1 变为 %2</translation>
    </message>
    <message>
        <source>submap %1 %2</source>
        <translation>子图 %1 %2</translation>
    </message>
    <message>
        <source> and </source>
        <translation> 并 </translation>
    </message>
    <message>
        <source>submap %1 is new</source>
        <translation>子图 %1 是新的</translation>
    </message>
    <message>
        <source>is called %1 now</source>
        <translation>现在名称为 %1</translation>
    </message>
    <message>
        <source>has a heading now</source>
        <translation>现在有了朝向</translation>
    </message>
    <message>
        <source>has no heading any more</source>
        <translation>不再有朝向</translation>
    </message>
    <message>
        <source>waypoint %1 is gone</source>
        <translation>路径点 %1 已消失</translation>
    </message>
    <message>
        <source>waypoint %1 %2</source>
        <translation>路径点 %1 %2</translation>
    </message>
    <message>
        <source>waypoint %1 is new</source>
        <translation>路径点 %1 是新的</translation>
    </message>
    <message>
        <source>the robot %1</source>
        <translation>机器人%1</translation>
    </message>
    <message>
        <source>the robot is drawn no more</source>
        <translation>不再绘制机器人</translation>
    </message>
    <message>
        <source>the robot is drawn now</source>
        <translation>现在绘制机器人</translation>
    </message>
    <message>
        <source>messages of other times: %1</source>
        <translation>时刻不同的消息：%1</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>已改变</translation>
    </message>
    <message>
        <source>No fact that is kept of it changed.</source>
        <translation>所保存的信息都没有变化。</translation>
    </message>
    <message>
        <source>Nothing changed there that is known.</source>
        <translation>已知那里没有任何变化。</translation>
    </message>
    <message numerus="yes">
        <source>%1 clusters: nothing known changed there.</source>
        <translation>
            <numerusform>%1 个聚簇：已知那里没有任何变化。</numerusform>
        </translation>
    </message>
    <message>
        <source>There or elsewhere: %1.</source>
        <translation>那里或别处：%1。</translation>
    </message>
    <message>
        <source>Elsewhere: %1.</source>
        <translation>别处：%1。</translation>
    </message>
</context>
<context>
    <name>FactsText</name>
    <message>
        <source>It does not hold the facts of a picture.</source>
        <translation>其中没有图像的附带信息。</translation>
    </message>
    <message>
        <source>Its version is %1; only version %2 can be read.</source>
        <translation>其版本为 %1；只能读取版本 %2。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>A submap in it cannot be read.</source>
        <translation>无法读取其中的一个子图。</translation>
    </message>
    <message>
        <source>A waypoint in it cannot be read: %1</source>
        <translation>无法读取其中的一个路径点：%1</translation>
    </message>
</context>
<context>
    <name>Failure</name>
    <message>
        <source>It was not added</source>
        <translation>未添加</translation>
    </message>
    <message>
        <source>It was not done</source>
        <translation>未完成</translation>
    </message>
    <message>
        <source>Whether it was added is unknown</source>
        <translation>是否已添加未知</translation>
    </message>
    <message>
        <source>Whether it was done is unknown</source>
        <translation>是否已完成未知</translation>
    </message>
    <message>
        <source>It was added, but cannot be read back</source>
        <translation>已添加，但无法读回</translation>
    </message>
    <message>
        <source>It was done, but the robot&apos;s answer was lost</source>
        <translation>已完成，但机器人的应答丢失了</translation>
    </message>
    <message>
        <source>It was not changed</source>
        <translation>未更改</translation>
    </message>
    <message>
        <source>Whether it was changed is unknown</source>
        <translation>是否已更改未知</translation>
    </message>
    <message>
        <source>It was changed, but the robot&apos;s answer was lost</source>
        <translation>已更改，但机器人的应答丢失了</translation>
    </message>
    <message>
        <source>Its thumbnail is empty</source>
        <translation>其缩略图是空的</translation>
    </message>
    <message>
        <source>Its picture is empty</source>
        <translation>其图像是空的</translation>
    </message>
    <message>
        <source>Its thumbnail cannot be loaded</source>
        <translation>无法加载其缩略图</translation>
    </message>
    <message>
        <source>Its picture cannot be loaded</source>
        <translation>无法加载其图像</translation>
    </message>
    <message>
        <source>The list cannot be read</source>
        <translation>无法读取列表</translation>
    </message>
    <message>
        <source>The list cannot be loaded</source>
        <translation>无法加载列表</translation>
    </message>
    <message>
        <source>Its points cannot be read</source>
        <translation>无法读取其中的点</translation>
    </message>
    <message>
        <source>Its points cannot be loaded</source>
        <translation>无法加载其中的点</translation>
    </message>
    <message>
        <source>The overview of the map cannot be read</source>
        <translation>无法读取地图的总览图</translation>
    </message>
    <message>
        <source>The overview of the map cannot be loaded</source>
        <translation>无法加载地图的总览图</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>It cannot be loaded</source>
        <translation>无法加载</translation>
    </message>
    <message>
        <source>the robot answered %1</source>
        <translation>机器人应答 %1</translation>
    </message>
    <message>
        <source>the robot refused</source>
        <translation>机器人拒绝了</translation>
    </message>
    <message>
        <source>the robot refused (code %1)</source>
        <translation>机器人拒绝了（代码 %1）</translation>
    </message>
    <message>
        <source>it was cancelled</source>
        <translation>已被取消</translation>
    </message>
    <message>
        <source>the connection was lost</source>
        <translation>连接已断开</translation>
    </message>
    <message>
        <source>no answer came in time</source>
        <translation>没有及时收到应答</translation>
    </message>
    <message>
        <source>someone else changed it in the meantime</source>
        <translation>在此期间已被他人修改</translation>
    </message>
    <message>
        <source>it failed</source>
        <translation>失败了</translation>
    </message>
    <message>
        <source>There is no such map.</source>
        <translation>没有这张地图。</translation>
    </message>
    <message>
        <source>There is no such object.</source>
        <translation>没有这个对象。</translation>
    </message>
    <message>
        <source>There are no thumbnails of maps here.</source>
        <translation>这里没有地图的缩略图。</translation>
    </message>
    <message>
        <source>It cannot be changed from here.</source>
        <translation>无法从这里修改。</translation>
    </message>
    <message>
        <source>This robot does not offer this.</source>
        <translation>该机器人不提供此功能。</translation>
    </message>
    <message>
        <source>This is not a valid id. Ids look like %1.</source>
        <translation>这不是有效的 id。id 的形式如 %1。</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>Shown without it.</source>
        <translation>显示时不包含它。</translation>
    </message>
    <message>
        <source>Shown without it. It will be requested again with the next version.</source>
        <translation>显示时不包含它。有下一个版本时会再次请求。</translation>
    </message>
    <message>
        <source>It stays where it was.</source>
        <translation>它留在原处。</translation>
    </message>
    <message>
        <source>It will be requested again.</source>
        <translation>会再次请求。</translation>
    </message>
    <message>
        <source>It will be requested again with the next version.</source>
        <translation>有下一个版本时会再次请求。</translation>
    </message>
    <message>
        <source>The previous picture stays.</source>
        <translation>保留之前的图像。</translation>
    </message>
    <message>
        <source>The previous alerts stay.</source>
        <translation>保留之前的告警。</translation>
    </message>
    <message>
        <source>They were left out.</source>
        <translation>它们已略去。</translation>
    </message>
    <message>
        <source>Its points were left out.</source>
        <translation>其中的点已略去。</translation>
    </message>
    <message>
        <source>It is requested again each time.</source>
        <translation>每次都会再次请求。</translation>
    </message>
    <message>
        <source>They are read again each time.</source>
        <translation>每次都会再次读取。</translation>
    </message>
    <message>
        <source>It is left unchanged.</source>
        <translation>保持不变。</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>未写入任何内容。</translation>
    </message>
</context>
<context>
    <name>FetchCloud</name>
    <message numerus="yes">
        <source>%1 points that the robot announced did not arrive: its answer is cut off.</source>
        <translation>
            <numerusform>机器人所告知的 %1 个点没有到达：其应答被截断。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 points lie outside the requested region and were left out.</source>
        <translation>
            <numerusform>%1 个点位于所请求的区域之外，已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more points have invalid or absurdly large coordinates and were left out.</source>
        <translation>
            <numerusform>另有 %1 个点的坐标无效或大得离谱，已略去。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FileValue</name>
    <message>
        <source>It is larger than %1 MiB.</source>
        <translation>它大于 %1 MiB。</translation>
    </message>
    <message>
        <source>It is too large or too deep for a list of waypoints.</source>
        <translation>作为路径点列表，它太大或嵌套太深。</translation>
    </message>
    <message>
        <source>It is not YAML (line %1).</source>
        <translation>它不是 YAML（第 %1 行）。</translation>
    </message>
    <message>
        <source>It is not YAML: text follows where the file should end.</source>
        <translation>它不是 YAML：文件应结束处之后还有文本。</translation>
    </message>
</context>
<context>
    <name>FoundRobot</name>
    <message numerus="yes">
        <source>%1 topics</source>
        <translation>
            <numerusform>%1 个话题</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 services</source>
        <translation>
            <numerusform>%1 个服务</numerusform>
        </translation>
    </message>
    <message>
        <source>asks for a secret</source>
        <translation>要求提供密钥</translation>
    </message>
</context>
<context>
    <name>HttpStatus</name>
    <message>
        <source>not modified</source>
        <translation>未修改</translation>
    </message>
    <message>
        <source>bad request</source>
        <translation>错误的请求</translation>
    </message>
    <message>
        <source>not authorised</source>
        <translation>未授权</translation>
    </message>
    <message>
        <source>forbidden</source>
        <translation>禁止访问</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>method not allowed</source>
        <translation>方法不被允许</translation>
    </message>
    <message>
        <source>request timeout</source>
        <translation>请求超时</translation>
    </message>
    <message>
        <source>conflict</source>
        <translation>冲突</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>已不存在</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>过大</translation>
    </message>
    <message>
        <source>unsupported media type</source>
        <translation>不支持的媒体类型</translation>
    </message>
    <message>
        <source>cannot be processed</source>
        <translation>无法处理</translation>
    </message>
    <message>
        <source>upgrade required</source>
        <translation>需要升级</translation>
    </message>
    <message>
        <source>too many requests</source>
        <translation>请求过多</translation>
    </message>
    <message>
        <source>internal error</source>
        <translation>内部错误</translation>
    </message>
    <message>
        <source>not implemented</source>
        <translation>未实现</translation>
    </message>
    <message>
        <source>bad gateway</source>
        <translation>网关错误</translation>
    </message>
    <message>
        <source>unavailable</source>
        <translation>不可用</translation>
    </message>
    <message>
        <source>gateway timeout</source>
        <translation>网关超时</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
</context>
<context>
    <name>Incident</name>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Position quality</source>
        <translation>位置质量</translation>
    </message>
    <message>
        <source>Lidar matching</source>
        <translation>激光雷达匹配</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, heading %3°</source>
        <translation>x %1 m，y %2 m，朝向 %3°</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1 (%2 of 10)</source>
        <translation>%1（%2 / 10）</translation>
    </message>
    <message>
        <source>The robot calls its position reliable.</source>
        <translation>机器人称其位置可靠。</translation>
    </message>
    <message>
        <source>The robot calls its position unreliable.</source>
        <translation>机器人称其位置不可靠。</translation>
    </message>
    <message>
        <source>lidar matching %1</source>
        <translation>激光雷达匹配度 %1</translation>
    </message>
    <message>
        <source>The lidar does not match the map.</source>
        <translation>激光雷达与地图不匹配。</translation>
    </message>
    <message>
        <source>The wheels slip.</source>
        <translation>轮子打滑。</translation>
    </message>
    <message>
        <source>action: %1</source>
        <translation>动作：%1</translation>
    </message>
    <message>
        <source>reason, as the robot says it: %1</source>
        <translation>原因（机器人自述）：%1</translation>
    </message>
    <message>
        <source>stuck, as the robot says it: %1</source>
        <translation>受困（机器人自述）：%1</translation>
    </message>
    <message>
        <source>%1 to go</source>
        <translation>剩余 %1</translation>
    </message>
    <message>
        <source>target: %1</source>
        <translation>目标：%1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>%1 UTC</source>
        <translation>%1 UTC</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>lost since %1 UTC: nothing was recorded</source>
        <translation>自 %1 UTC 起丢失：没有录制任何内容</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>SLAM</source>
        <translation>SLAM</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>规划器</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>版本 %1</translation>
    </message>
    <message>
        <source>The bag holds no picture of the map: the robot&apos;s present one is drawn.</source>
        <translation>数据包中没有地图图像：绘制的是机器人现在的图像。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>%1 % up</source>
        <translation>升起 %1%</translation>
    </message>
    <message>
        <source>Jack</source>
        <translation>顶升</translation>
    </message>
    <message>
        <source>cargo detected</source>
        <translation>检测到货物</translation>
    </message>
    <message>
        <source>no cargo</source>
        <translation>无货物</translation>
    </message>
    <message>
        <source>Towing</source>
        <translation>牵引</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>已按下</translation>
    </message>
    <message>
        <source>not pressed</source>
        <translation>未按下</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>%1 (since before the recording begins)</source>
        <translation>%1（录制开始之前就已存在）</translation>
    </message>
    <message>
        <source>%1 (since %2, for %3)</source>
        <translation>%1（自 %2 起，已持续 %3）</translation>
    </message>
    <message>
        <source>%1, in other words since %2</source>
        <translation>%1，自 %2 起措辞不同</translation>
    </message>
    <message>
        <source>none that the robot reports</source>
        <translation>机器人没有上报任何情况</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>状况</translation>
    </message>
    <message>
        <source>There is nothing to draw: the bag has no map and no position up to this time.</source>
        <translation>没有可绘制的内容：到该时间为止，数据包中没有地图和位置。</translation>
    </message>
    <message>
        <source>The map around the robot at %1 UTC, with its path, scan and overlays</source>
        <translation>%1 UTC 时机器人周围的地图，以及其路径、激光扫描和覆盖物</translation>
    </message>
    <message>
        <source>The bag holds no numbers of this minute.</source>
        <translation>数据包中没有这一分钟的数值。</translation>
    </message>
    <message>
        <source>0 s is %1 UTC.</source>
        <translation>0 s 为 %1 UTC。</translation>
    </message>
    <message numerus="yes">
        <source>%1 earlier events are left out.</source>
        <translation>
            <numerusform>略去了 %1 个更早的事件。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing happened in the five minutes before.</source>
        <translation>此前五分钟内没有发生任何事件。</translation>
    </message>
    <message>
        <source>Time (UTC)</source>
        <translation>时间 (UTC)</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>%1%2 s</source>
        <translation>%1%2 s</translation>
    </message>
    <message>
        <source>the moment of this report</source>
        <translation>本报告的时刻</translation>
    </message>
    <message>
        <source>%1 (was there already when the recording begins)</source>
        <translation>%1（录制开始时就已存在）</translation>
    </message>
    <message>
        <source>No path is known at this time.</source>
        <translation>此时没有已知的路径。</translation>
    </message>
    <message>
        <source>Only the local path is known.</source>
        <translation>只知道局部路径。</translation>
    </message>
    <message>
        <source>The robot is %1 away from this path.</source>
        <translation>机器人距该路径 %1。</translation>
    </message>
    <message>
        <source>No wall, region or door lies on the rest of the path.</source>
        <translation>剩余路径上没有墙、区域或门。</translation>
    </message>
    <message>
        <source>Along the path</source>
        <translation>沿路径距离</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>How near</source>
        <translation>远近</translation>
    </message>
    <message>
        <source>%1 beside it</source>
        <translation>旁边 %1</translation>
    </message>
    <message>
        <source>the robot is there</source>
        <translation>机器人就在那里</translation>
    </message>
    <message>
        <source>on the path</source>
        <translation>在路径上</translation>
    </message>
    <message>
        <source>Those that are farther away are left out.</source>
        <translation>更远的已略去。</translation>
    </message>
    <message>
        <source>What the path crosses or passes within %1, half the robot&apos;s width.</source>
        <translation>路径穿过的，或在 %1（机器人宽度的一半）以内经过的内容。</translation>
    </message>
    <message>
        <source>Only what the path crosses: the robot&apos;s width is not known.</source>
        <translation>只列出路径穿过的内容：机器人的宽度未知。</translation>
    </message>
    <message>
        <source>Older than %1 s at this time</source>
        <translation>此时早于 %1 s 的消息</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>话题</translation>
    </message>
    <message>
        <source>Last message (UTC)</source>
        <translation>最后一条消息 (UTC)</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>距今</translation>
    </message>
    <message>
        <source>The robot believed to be at %1.</source>
        <translation>机器人认为自己位于 %1。</translation>
    </message>
    <message>
        <source>Where the robot believed to be is not known.</source>
        <translation>机器人认为自己在哪里不得而知。</translation>
    </message>
    <message>
        <source>Its planner: %1.</source>
        <translation>其规划器：%1。</translation>
    </message>
    <message>
        <source>It is at %1.</source>
        <translation>它位于 %1。</translation>
    </message>
    <message>
        <source>The next thing on its path is %1, after %2.</source>
        <translation>其路径上的下一个对象是 %1，还有 %2。</translation>
    </message>
    <message>
        <source>%1 holds no messages.</source>
        <translation>%1 中没有消息。</translation>
    </message>
    <message>
        <source>%1: %2 UTC is not within it: it lasts from %3 to %4 UTC.</source>
        <translation>%1：%2 UTC 不在其范围内：该文件从 %3 到 %4 UTC。</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>门</translation>
    </message>
    <message>
        <source>The robot says itself why it failed: %1.</source>
        <translation>机器人自述失败的原因：%1。</translation>
    </message>
    <message>
        <source>The robot reports alert %1: %2</source>
        <translation>机器人上报告警 %1：%2</translation>
    </message>
    <message>
        <source>it gives no further text.</source>
        <translation>它没有给出更多文字。</translation>
    </message>
    <message>
        <source>The emergency stop is pressed.</source>
        <translation>急停已按下。</translation>
    </message>
    <message>
        <source>It stands still, which is consistent with the emergency stop that is pressed.</source>
        <translation>它静止不动，这与急停已按下相符。</translation>
    </message>
    <message>
        <source>The emergency stop is pressed, and yet its positions change at %1 m/s.</source>
        <translation>急停已按下，但其位置仍以 %1 m/s 变化。</translation>
    </message>
    <message>
        <source>It stands still although it has a way to go, which is consistent with being held up at %1, %2 ahead.</source>
        <translation>它还有路程却静止不动，这与在前方 %2 的 %1 处受阻相符。</translation>
    </message>
    <message>
        <source>Its position jumped by %1 at %2</source>
        <translation>其位置在 %2 跳变了 %1</translation>
    </message>
    <message>
        <source>%1, which is consistent with its localization, poor since %2.</source>
        <translation>%1，这与其定位自 %2 起较差相符。</translation>
    </message>
    <message>
        <source>%1, which is consistent with the poor localization.</source>
        <translation>%1，这与定位较差相符。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>Its localization is poor: it may have been elsewhere.</source>
        <translation>其定位较差：它可能在别处。</translation>
    </message>
    <message>
        <source>Position: the bag holds none up to this time.</source>
        <translation>位置：到该时间为止，数据包中没有。</translation>
    </message>
    <message>
        <source>Position quality: not in the bag up to this time.</source>
        <translation>位置质量：到该时间为止，数据包中没有说明。</translation>
    </message>
    <message>
        <source>Speed: there are too few positions around this time.</source>
        <translation>速度：该时间前后的位置太少。</translation>
    </message>
    <message>
        <source>Planner state: not in the bag up to this time.</source>
        <translation>规划器：到该时间为止，数据包中没有说明其状态。</translation>
    </message>
    <message>
        <source>Path: the bag holds none up to this time.</source>
        <translation>路径：到该时间为止，数据包中没有。</translation>
    </message>
    <message>
        <source>Emergency stop: not in the bag up to this time.</source>
        <translation>急停：到该时间为止，数据包中没有说明。</translation>
    </message>
    <message>
        <source>Bumpers: the bag has no topic about them up to this time.</source>
        <translation>防撞条：到该时间为止，数据包中没有相关话题。</translation>
    </message>
    <message>
        <source>Battery: not in the bag up to this time.</source>
        <translation>电池：到该时间为止，数据包中没有说明。</translation>
    </message>
    <message>
        <source>Scan: the bag holds none up to this time.</source>
        <translation>激光扫描：到该时间为止，数据包中没有。</translation>
    </message>
    <message>
        <source>The robot&apos;s outline: not in the bag up to this time.</source>
        <translation>机器人外形：到该时间为止，数据包中没有说明。</translation>
    </message>
    <message>
        <source>Map: the bag does not say which one was used up to this time.</source>
        <translation>地图：到该时间为止，数据包中没有说明使用的是哪一张。</translation>
    </message>
    <message>
        <source>Overlays: none are known, so walls, regions and doors may be missing.</source>
        <translation>覆盖物：没有已知的覆盖物，因此可能缺少墙、区域和门。</translation>
    </message>
    <message>
        <source>Topic %1 begins only later.</source>
        <translation>话题 %1 在此之后才开始。</translation>
    </message>
    <message>
        <source>The recording was interrupted, or is still going on.</source>
        <translation>录制中断了，或者仍在进行。</translation>
    </message>
    <message>
        <source>Incident report: %1, %2 UTC</source>
        <translation>事件报告：%1，%2 UTC</translation>
    </message>
    <message>
        <source>What the recording says about this moment. All times are UTC. What is said to be consistent was so at the same time; only what the robot says itself is a reason.</source>
        <translation>录制文件对这一时刻的说明。所有时间均为 UTC。所谓“相符”只表示同时发生；只有机器人自述的才是原因。</translation>
    </message>
    <message>
        <source>Beside it: %1 at %2 UTC.</source>
        <translation>对照：%1，%2 UTC。</translation>
    </message>
    <message>
        <source>That is when this run came nearest to the same place: %1 away.</source>
        <translation>这是该次运行离同一地点最近的时刻：相距 %1。</translation>
    </message>
    <message>
        <source>Its robot is %1 away from the same place.</source>
        <translation>其机器人与同一地点相距 %1。</translation>
    </message>
    <message>
        <source>The two runs use different maps, so their positions may not fit.</source>
        <translation>两次运行使用不同的地图，因此其位置可能对不上。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>In short</source>
        <translation>概要</translation>
    </message>
    <message>
        <source>What the robot believed</source>
        <translation>机器人的判断</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>On the way</source>
        <translation>沿途</translation>
    </message>
    <message>
        <source>The minute around it</source>
        <translation>前后一分钟</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>未知的内容</translation>
    </message>
    <message>
        <source>%1 has no position, so the same place cannot be found. Give the time instead.</source>
        <translation>%1 没有位置，因此找不到同一地点。请改为给出时间。</translation>
    </message>
    <message>
        <source>The map is not drawn. %1</source>
        <translation>未绘制地图。%1</translation>
    </message>
    <message>
        <source>Submaps that could not be drawn: %1 of %2.</source>
        <translation>无法绘制的子图：%1 / %2。</translation>
    </message>
    <message>
        <source>The position at this time is unknown, so the same place cannot be found in the other run. Give its time instead.</source>
        <translation>此时的位置未知，因此在另一次运行中找不到同一地点。请改为给出其时间。</translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>还有 %1 个未列出。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more topics begin only later.</source>
        <translation>
            <numerusform>还有 %1 个话题稍后才开始。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>JudgementText</name>
    <message>
        <source>The facts beside %1 are of another picture.</source>
        <translation>%1 附带的信息属于另一张图像。</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
</context>
<context>
    <name>LayerPresets</name>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Navigation</source>
        <translation>导航</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>建图</translation>
    </message>
    <message>
        <source>Map only</source>
        <translation>仅地图</translation>
    </message>
</context>
<context>
    <name>LeaveOut</name>
    <message>
        <source>Left out: trajectories %1, submaps %2, nodes %3, INTER constraints %4, INTRA constraints %5; records %6.</source>
        <translation>已去掉：轨迹 %1，子图 %2，节点 %3，INTER 约束 %4，INTRA 约束 %5；记录 %6。</translation>
    </message>
    <message>
        <source>%1 was written, read again and compared. Rewritten: the pose graph%2; every other record kept its bytes.</source>
        <translation>%1 已写入、重新读取并比较。重新写入的内容：位姿图%2；其他记录均逐字节保留。</translation>
    </message>
    <message>
        <source> and the options</source>
        <translation> 和选项</translation>
    </message>
    <message>
        <source>No pose has changed: Cartographer optimises them when it loads the file and runs again.</source>
        <translation>位姿没有改变：Cartographer 在加载该文件并再次运行时会进行优化。</translation>
    </message>
    <message>
        <source>Damaged, and copied as it is: %1</source>
        <translation>已损坏，按原样复制：%1</translation>
    </message>
    <message>
        <source>More records that are damaged and were copied: %1.</source>
        <translation>其他已损坏并按原样复制的记录：%1。</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Seen by one submap only: unverified</source>
        <translation>只由一个子图见到：未经印证</translation>
    </message>
    <message>
        <source>Seen by 2 submaps</source>
        <translation>由 2 个子图见到</translation>
    </message>
    <message>
        <source>3 to 4</source>
        <translation>3 至 4</translation>
    </message>
    <message>
        <source>5 to 8</source>
        <translation>5 至 8</translation>
    </message>
    <message>
        <source>9 to 16</source>
        <translation>9 至 16</translation>
    </message>
    <message>
        <source>17 or more</source>
        <translation>17 或更多</translation>
    </message>
    <message>
        <source>Occupied in one submap, free in another</source>
        <translation>在一个子图中占据，在另一个中空闲</translation>
    </message>
    <message>
        <source>Pallet, rack or object, with its heading</source>
        <translation>托盘、货架或物体，及其朝向</translation>
    </message>
    <message>
        <source>Loop closure that fits the map</source>
        <translation>与地图相符的回环</translation>
    </message>
    <message>
        <source>Off by more than 0.1 m</source>
        <translation>偏差大于 0.1 m</translation>
    </message>
    <message>
        <source>Contradicts the map by more than 0.5 m</source>
        <translation>与地图矛盾超过 0.5 m</translation>
    </message>
    <message>
        <source>low</source>
        <translation>低</translation>
    </message>
    <message>
        <source>high</source>
        <translation>高</translation>
    </message>
    <message>
        <source>weak</source>
        <translation>弱</translation>
    </message>
    <message>
        <source>strong echo</source>
        <translation>强回波</translation>
    </message>
    <message>
        <source>Point of the map</source>
        <translation>地图的点</translation>
    </message>
    <message>
        <source>Constraint</source>
        <translation>约束</translation>
    </message>
    <message>
        <source>Residual: the error that remains</source>
        <translation>残差：剩余的误差</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Moving, or state unknown</source>
        <translation>移动中，或状态未知</translation>
    </message>
    <message>
        <source>Grid line</source>
        <translation>网格线</translation>
    </message>
    <message>
        <source>Line of the coarse grid</source>
        <translation>粗网格线</translation>
    </message>
    <message>
        <source>Axes: x = 0 and y = 0</source>
        <translation>坐标轴：x = 0 和 y = 0</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>路标</translation>
    </message>
    <message>
        <source>Landmark that is not in use</source>
        <translation>未使用的路标</translation>
    </message>
    <message>
        <source>Not on the reference map</source>
        <translation>参考地图上没有</translation>
    </message>
    <message>
        <source>On the reference map only</source>
        <translation>仅参考地图上有</translation>
    </message>
    <message>
        <source>Known on the reference map only</source>
        <translation>仅在参考地图上已知</translation>
    </message>
    <message>
        <source>Unknown on the reference map</source>
        <translation>在参考地图上未知</translation>
    </message>
    <message>
        <source>Occupied in both</source>
        <translation>两张中均占据</translation>
    </message>
    <message>
        <source>Free in both</source>
        <translation>两张中均空闲</translation>
    </message>
    <message>
        <source>Differences from the reference map</source>
        <translation>与参考地图的差异</translation>
    </message>
    <message>
        <source>New since then</source>
        <translation>此后新增</translation>
    </message>
    <message>
        <source>New in the second map</source>
        <translation>第二张地图中新增</translation>
    </message>
    <message>
        <source>Gone since then</source>
        <translation>此后消失</translation>
    </message>
    <message>
        <source>Gone in the second map</source>
        <translation>第二张地图中消失</translation>
    </message>
    <message>
        <source>Known then only</source>
        <translation>仅当时已知</translation>
    </message>
    <message>
        <source>Known in the first map only</source>
        <translation>仅在第一张地图中已知</translation>
    </message>
    <message>
        <source>Known now only</source>
        <translation>仅现在已知</translation>
    </message>
    <message>
        <source>Known in the second map only</source>
        <translation>仅在第二张地图中已知</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>Occupied</source>
        <translation>占据</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Lidar point</source>
        <translation>激光雷达点</translation>
    </message>
    <message>
        <source>Next part of the path, as wide as the robot</source>
        <translation>下一段路径，与机器人同宽</translation>
    </message>
    <message>
        <source>Other robot; dotted: where it is going</source>
        <translation>其他机器人；虚线：其去向</translation>
    </message>
    <message>
        <source>Submap</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Frozen submap</source>
        <translation>已冻结的子图</translation>
    </message>
    <message>
        <source>Trajectory and number of a submap</source>
        <translation>子图的轨迹和编号</translation>
    </message>
    <message>
        <source>Submap that you have hidden</source>
        <translation>您已隐藏的子图</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Other regions</source>
        <translation>其他区域</translation>
    </message>
    <message>
        <source>Other lines</source>
        <translation>其他线</translation>
    </message>
    <message>
        <source>Other points</source>
        <translation>其他点</translation>
    </message>
    <message>
        <source>Planned path to the target</source>
        <translation>到目标的规划路径</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>matches</source>
        <translation>相符</translation>
    </message>
    <message>
        <source>high cost</source>
        <translation>高代价</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>Colours of the robot</source>
        <translation>机器人的颜色</translation>
    </message>
    <message>
        <source>Too close for the robot&apos;s centre</source>
        <translation>机器人中心不能再靠近的范围</translation>
    </message>
    <message>
        <source>Where the robot was</source>
        <translation>机器人到过的位置</translation>
    </message>
    <message>
        <source>The outline with its safety margin</source>
        <translation>带安全余量的外形</translation>
    </message>
    <message>
        <source>Outline of the robot</source>
        <translation>机器人外形</translation>
    </message>
    <message>
        <source>Robot; the tip is its front</source>
        <translation>机器人；尖端为车头</translation>
    </message>
    <message>
        <source>Trajectory %1</source>
        <translation>轨迹 %1</translation>
    </message>
    <message>
        <source>Trajectories %1</source>
        <translation>轨迹 %1</translation>
    </message>
    <message>
        <source>older</source>
        <translation>较旧</translation>
    </message>
    <message>
        <source>newer</source>
        <translation>较新</translation>
    </message>
    <message>
        <source>few scans</source>
        <translation>扫描少</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 及以上</translation>
    </message>
    <message>
        <source>Version unknown</source>
        <translation>版本未知</translation>
    </message>
    <message>
        <source>Free, of incremental submaps</source>
        <translation>空闲，来自增量子图</translation>
    </message>
    <message>
        <source>Occupied, of incremental submaps</source>
        <translation>占据，来自增量子图</translation>
    </message>
    <message>
        <source>Free, of frozen submaps</source>
        <translation>空闲，来自已冻结的子图</translation>
    </message>
    <message>
        <source>Occupied, of frozen submaps</source>
        <translation>占据，来自已冻结的子图</translation>
    </message>
    <message>
        <source>Target, with its heading</source>
        <translation>目标，及其朝向</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>end of the bag</source>
        <translation>数据包末尾</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>最快</translation>
    </message>
    <message>
        <source>Localization: good</source>
        <translation>定位：良好</translation>
    </message>
    <message>
        <source>Localization: fair</source>
        <translation>定位：一般</translation>
    </message>
    <message>
        <source>Localization: poor or lost</source>
        <translation>定位：较差或丢失</translation>
    </message>
    <message>
        <source>Localization: unknown</source>
        <translation>定位：未知</translation>
    </message>
    <message>
        <source>Path along which the map was made</source>
        <translation>建图时经过的路径</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Changed, not saved yet</source>
        <translation>已更改，尚未保存</translation>
    </message>
    <message>
        <source>New, not saved yet</source>
        <translation>新建，尚未保存</translation>
    </message>
    <message>
        <source>Deleted, not saved yet</source>
        <translation>已删除，尚未保存</translation>
    </message>
    <message>
        <source>Sent, not confirmed yet</source>
        <translation>已下发，尚未确认</translation>
    </message>
    <message>
        <source>In conflict: mine</source>
        <translation>有冲突：我的</translation>
    </message>
    <message>
        <source>In conflict: the other version</source>
        <translation>有冲突：对方的版本</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>已选择</translation>
    </message>
    <message>
        <source>With a warning</source>
        <translation>有警告</translation>
    </message>
    <message>
        <source>Walls off by more than 10 cm</source>
        <translation>墙偏差超过 10 cm</translation>
    </message>
    <message>
        <source>Walls off by more than 30 cm</source>
        <translation>墙偏差超过 30 cm</translation>
    </message>
    <message>
        <source>Walls off by more than 1 m</source>
        <translation>墙偏差超过 1 m</translation>
    </message>
</context>
<context>
    <name>MapByRegions</name>
    <message>
        <source>%1 × %2 cells, about %3</source>
        <translation>%1 × %2 栅格，约 %3</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>regions: %1 loaded</source>
        <translation>分块：已加载 %1</translation>
    </message>
    <message>
        <source>regions: zoom in, %1</source>
        <translation>分块：请放大，%1</translation>
    </message>
    <message>
        <source>%1 of %2 regions, %3</source>
        <translation>分块 %1 / %2，%3</translation>
    </message>
    <message>
        <source>%1 × %2 m</source>
        <translation>%1 × %2 m</translation>
    </message>
    <message>
        <source>%1: %2 × %3 cells, about %4</source>
        <translation>%1：%2 × %3 栅格，约 %4</translation>
    </message>
    <message>
        <source>Its size is unknown: the robot does not report it.</source>
        <translation>其大小未知：机器人没有上报。</translation>
    </message>
    <message>
        <source>The known part covers %1. It may be larger: the robot does not report its size.</source>
        <translation>已知部分为 %1。实际可能更大：机器人没有上报其大小。</translation>
    </message>
    <message>
        <source>The robot reports its size as %1: %2 × %3 cells, about %4 over the network.</source>
        <translation>机器人上报的大小为 %1：%2 × %3 栅格，网络传输约 %4。</translation>
    </message>
    <message>
        <source>Regions outside of that have been received: it is larger.</source>
        <translation>已收到该范围之外的分块：地图更大。</translation>
    </message>
    <message>
        <source>The link accepts at most %1 per message: the transfer may fail, and then nothing is received.</source>
        <translation>该链路每条消息最多接受 %1：传输可能失败，那样什么都收不到。</translation>
    </message>
    <message>
        <source>The whole map is too large to be fetched at once: its %1 × %2 cells are at least %3 over the network, but the limit is %4. Fetch a region instead.</source>
        <translation>整张地图太大，无法一次获取：其 %1 × %2 栅格在网络传输中至少 %3，而上限为 %4。请改为获取一个分块。</translation>
    </message>
    <message>
        <source>Fetching the whole map, for %1 s. Nothing has arrived yet.</source>
        <translation>正在获取整张地图，已用 %1 s。尚未收到任何内容。</translation>
    </message>
    <message>
        <source>Fetching the whole map: %1 of about %2 so far, for %3 s.</source>
        <translation>正在获取整张地图：目前 %1，共约 %2，已用 %3 s。</translation>
    </message>
    <message>
        <source>Fetching the whole map: %1 so far, for %2 s.</source>
        <translation>正在获取整张地图：目前 %1，已用 %2 s。</translation>
    </message>
    <message>
        <source>Old: this region could not be fetched again. %1</source>
        <translation>旧数据：该分块无法再次获取。%1</translation>
    </message>
    <message>
        <source>Empty: the robot says that its map has nothing in this region.</source>
        <translation>空：机器人称其地图在该分块中没有内容。</translation>
    </message>
    <message>
        <source>Not fetched: there is no connection to the robot.</source>
        <translation>未获取：没有与机器人的连接。</translation>
    </message>
    <message>
        <source>Not fetched: the robot no longer sends its map by region.</source>
        <translation>未获取：机器人不再按分块发送地图。</translation>
    </message>
    <message>
        <source>Not fetched: too much of the map is visible. Zoom in.</source>
        <translation>未获取：显示的地图范围太大。请放大。</translation>
    </message>
    <message>
        <source>This region could not be fetched and will be tried again automatically. %1</source>
        <translation>该分块无法获取，会自动重试。%1</translation>
    </message>
    <message>
        <source>This region is being fetched.</source>
        <translation>正在获取该分块。</translation>
    </message>
    <message>
        <source>Not fetched yet: this region is waiting for the ones before it.</source>
        <translation>尚未获取：该分块在等待前面的分块。</translation>
    </message>
    <message>
        <source>No region of the map could be fetched: %1</source>
        <translation>地图的任何分块都无法获取：%1</translation>
    </message>
    <message>
        <source>Not fetched yet: waiting for the robot&apos;s first answer.</source>
        <translation>尚未获取：正在等待机器人的第一个应答。</translation>
    </message>
    <message>
        <source>Too much of the map is visible, and the whole map is too large to fetch at once. Zoom in, or fetch a region.</source>
        <translation>显示的地图范围太大，而整张地图又大得无法一次获取。请放大，或获取一个分块。</translation>
    </message>
    <message>
        <source>Too much of the map is visible to be fetched. Zoom in.</source>
        <translation>显示的地图范围太大，无法获取。请放大。</translation>
    </message>
    <message>
        <source>Too much of the map is visible. Zoom in, or fetch the whole map.</source>
        <translation>显示的地图范围太大。请放大，或获取整张地图。</translation>
    </message>
    <message>
        <source>Too much of the map is visible. Zoom in, or fetch the whole map: %1.</source>
        <translation>显示的地图范围太大。请放大，或获取整张地图：%1。</translation>
    </message>
    <message>
        <source>The robot&apos;s answers are smaller than the requested regions (%1 of %2): the missing parts are blank.</source>
        <translation>机器人的应答小于所请求的分块（%1 / %2）：缺少的部分为空白。</translation>
    </message>
    <message>
        <source>Some of the visible regions could not be fetched (%1 of %2 are missing or old): %3</source>
        <translation>部分可见分块无法获取（%1 / %2 缺失或为旧数据）：%3</translation>
    </message>
</context>
<context>
    <name>MapFacts</name>
    <message>
        <source>%1 (%2 %, %3)</source>
        <translation>%1（%2%，%3）</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Uid</source>
        <translation>UID</translation>
    </message>
    <message>
        <source>Map name</source>
        <translation>地图名称</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Overlays version</source>
        <translation>覆盖物版本</translation>
    </message>
    <message>
        <source>Used by the robot</source>
        <translation>机器人正在使用</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>更改时间</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>%1 × %2 cells</source>
        <translation>%1 × %2 栅格</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>%1 m per cell</source>
        <translation>每栅格 %1 m</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋转角度</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Free cells</source>
        <translation>空闲栅格</translation>
    </message>
    <message>
        <source>Occupied cells</source>
        <translation>占据栅格</translation>
    </message>
    <message>
        <source>Unknown cells</source>
        <translation>未知栅格</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
</context>
<context>
    <name>MapFolder</name>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>%1 is too large.</source>
        <translation>%1 太大。</translation>
    </message>
    <message>
        <source>%1 is not the file that was downloaded: its size or checksum differs.</source>
        <translation>%1 不是当时下载的文件：其大小或校验和不同。</translation>
    </message>
    <message>
        <source>A map is downloaded into a folder: name one.</source>
        <translation>地图要下载到文件夹中：请指定一个。</translation>
    </message>
    <message>
        <source>%1 is not a folder.</source>
        <translation>%1 不是文件夹。</translation>
    </message>
    <message>
        <source>%1 already holds a map.</source>
        <translation>%1 中已有一张地图。</translation>
    </message>
    <message>
        <source>%1 already holds a file %2 that is of no downloaded map.</source>
        <translation>%1 中已有文件 %2，它不属于任何下载的地图。</translation>
    </message>
    <message>
        <source>The download into %1 is not finished.</source>
        <translation>到 %1 的下载没有完成。</translation>
    </message>
    <message>
        <source>%1 holds no downloaded map: there is no %2 that can be read.</source>
        <translation>%1 中没有下载的地图：没有可读取的 %2。</translation>
    </message>
    <message>
        <source>The %2 of %1 does not describe a downloaded map.</source>
        <translation>%1 的 %2 描述的不是下载的地图。</translation>
    </message>
    <message>
        <source>The %3 of %1 does not list %2, which lies beside it.</source>
        <translation>%1 的 %3 没有列出旁边的 %2。</translation>
    </message>
</context>
<context>
    <name>MapObject</name>
    <message>
        <source>Pallet</source>
        <translation>托盘</translation>
    </message>
    <message>
        <source>Rack</source>
        <translation>货架</translation>
    </message>
    <message>
        <source>Charger</source>
        <translation>充电桩</translation>
    </message>
    <message>
        <source>Seen object</source>
        <translation>识别到的物体</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Loop closure</source>
        <translation>回环</translation>
    </message>
    <message>
        <source>Contradicts the map by</source>
        <translation>与地图的矛盾</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋转角度</translation>
    </message>
    <message>
        <source>Submap</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>Constraint</source>
        <translation>约束</translation>
    </message>
    <message>
        <source>Automatic door</source>
        <translation>自动门</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>MAC address</source>
        <translation>MAC 地址</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>路标</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>Lidar point</source>
        <translation>激光雷达点</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Local path</source>
        <translation>局部路径</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>lies here</source>
        <translation>实际在这里</translation>
    </message>
    <message>
        <source>should lie here</source>
        <translation>应在这里</translation>
    </message>
    <message>
        <source>Nearby robot</source>
        <translation>附近的机器人</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Map version</source>
        <translation>地图版本</translation>
    </message>
    <message>
        <source>Overlays version</source>
        <translation>覆盖物版本</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Localization</source>
        <translation>定位</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>可靠</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Trail</source>
        <translation>尾迹</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1, on screen %2</source>
        <translation>%1，屏幕上为 %2</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>已冻结</translation>
    </message>
    <message>
        <source>active</source>
        <translation>活动</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Distance left</source>
        <translation>剩余距离</translation>
    </message>
    <message>
        <source>Why it failed</source>
        <translation>失败原因</translation>
    </message>
    <message>
        <source>Track of the bag</source>
        <translation>数据包的行驶轨迹</translation>
    </message>
    <message>
        <source>Time in the bag</source>
        <translation>数据包中的时间</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>changed, not saved</source>
        <translation>已更改，未保存</translation>
    </message>
    <message>
        <source>sent, not confirmed</source>
        <translation>已下发，未确认</translation>
    </message>
    <message>
        <source>in conflict: mine</source>
        <translation>有冲突：我的</translation>
    </message>
    <message>
        <source>new, not saved</source>
        <translation>新建，未保存</translation>
    </message>
    <message>
        <source>deleted, not saved</source>
        <translation>已删除，未保存</translation>
    </message>
    <message>
        <source>in conflict: theirs</source>
        <translation>有冲突：对方的</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
</context>
<context>
    <name>NewMap</name>
    <message>
        <source>The resolution must be between %1 and %2 metres per cell, for example 0.05.</source>
        <translation>分辨率必须在每栅格 %1 到 %2 米之间，例如 0.05。</translation>
    </message>
    <message>
        <source>The origin must be within 10,000 km.</source>
        <translation>原点必须在 10,000 km 以内。</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>%1 is larger than 128 MiB.</source>
        <translation>%1 大于 128 MiB。</translation>
    </message>
    <message>
        <source>It is not a PNG picture.</source>
        <translation>它不是 PNG 图像。</translation>
    </message>
    <message>
        <source>It has %1 x %2 pixels. At most %3 along an edge, and 100 million in all, can be the map of a robot.</source>
        <translation>它为 %1 x %2 像素。机器人的地图每边最多 %3 像素，总共最多一亿像素。</translation>
    </message>
    <message>
        <source>The picture is damaged or cut off.</source>
        <translation>图像已损坏或被截断。</translation>
    </message>
    <message>
        <source>it is called &quot;%1&quot;</source>
        <translation>其名称为“%1”</translation>
    </message>
    <message>
        <source>its resolution is %1 m</source>
        <translation>其分辨率为 %1 m</translation>
    </message>
    <message>
        <source>its lower left corner is at %1, %2 m</source>
        <translation>其左下角在 %1，%2 m</translation>
    </message>
    <message>
        <source>its data has %1 of %2 bytes</source>
        <translation>其数据只有 %2 字节中的 %1</translation>
    </message>
    <message>
        <source>its picture cannot be loaded</source>
        <translation>无法加载其图像</translation>
    </message>
    <message>
        <source>its picture is another one</source>
        <translation>其图像是另一张</translation>
    </message>
    <message>
        <source>it has no overlays</source>
        <translation>它没有覆盖物</translation>
    </message>
    <message>
        <source>its overlays are other ones</source>
        <translation>其覆盖物不同</translation>
    </message>
    <message>
        <source>it has another uid</source>
        <translation>其 uid 不同</translation>
    </message>
</context>
<context>
    <name>ObjectFacts</name>
    <message>
        <source>, version %1</source>
        <translation>，版本 %1</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>话题</translation>
    </message>
    <message>
        <source>Last message</source>
        <translation>最后一条消息</translation>
    </message>
    <message>
        <source>%1 (%2 ago)</source>
        <translation>%1（%2前）</translation>
    </message>
    <message>
        <source>The same since</source>
        <translation>此后未变</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>中点</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>From the robot</source>
        <translation>距机器人</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>属于</translation>
    </message>
</context>
<context>
    <name>Obstacle</name>
    <message>
        <source>The maps of this robot cannot be renamed from here.</source>
        <translation>无法从这里重命名该机器人的地图。</translation>
    </message>
    <message>
        <source>The current map of this robot cannot be changed from here.</source>
        <translation>无法从这里更改该机器人的当前地图。</translation>
    </message>
    <message>
        <source>This robot has no map archive.</source>
        <translation>该机器人没有地图归档。</translation>
    </message>
    <message>
        <source>The maps of this robot cannot be deleted from here.</source>
        <translation>无法从这里删除该机器人的地图。</translation>
    </message>
    <message>
        <source>Mapping cannot be started on this robot from here.</source>
        <translation>无法从这里让该机器人开始建图。</translation>
    </message>
    <message>
        <source>The current map of this robot cannot be extended from here.</source>
        <translation>无法从这里扩展该机器人的当前地图。</translation>
    </message>
    <message>
        <source>Mapping cannot be cancelled on this robot from here.</source>
        <translation>无法从这里取消该机器人的建图。</translation>
    </message>
    <message>
        <source>The mapping result of this robot cannot be saved from here.</source>
        <translation>无法从这里保存该机器人的建图结果。</translation>
    </message>
    <message>
        <source>This only works with a stored map, not with the one being mapped.</source>
        <translation>这只适用于已存地图，不适用于正在建的地图。</translation>
    </message>
    <message>
        <source>Not while the robot is mapping: stop mapping first.</source>
        <translation>机器人建图时不可用：请先停止建图。</translation>
    </message>
    <message>
        <source>The robot is not mapping.</source>
        <translation>机器人没有在建图。</translation>
    </message>
    <message>
        <source>It is archived: restore it from the archive first.</source>
        <translation>它已归档：请先从归档中恢复。</translation>
    </message>
    <message>
        <source>It is not archived.</source>
        <translation>它没有归档。</translation>
    </message>
    <message>
        <source>The robot already uses it.</source>
        <translation>机器人已在使用它。</translation>
    </message>
    <message>
        <source>This robot ends a mapping by saving the map, or by discarding it.</source>
        <translation>该机器人通过保存地图或放弃地图来结束建图。</translation>
    </message>
    <message>
        <source>The robot has not reported its state yet.</source>
        <translation>机器人尚未上报其状态。</translation>
    </message>
    <message>
        <source>There is no new map to save.</source>
        <translation>没有可保存的新地图。</translation>
    </message>
</context>
<context>
    <name>OutcomeText</name>
    <message>
        <source>%1 × %2 at %3, %4</source>
        <translation>%1 × %2，位于 %3, %4</translation>
    </message>
    <message>
        <source>nothing that is known</source>
        <translation>没有已知的内容</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 -&gt; %3</source>
        <translation>%1 %2 -&gt; %3</translation>
    </message>
    <message>
        <source>The worst loop closures:</source>
        <translation>最差的回环：</translation>
    </message>
    <message>
        <source>The worst squares of 1 m:</source>
        <translation>最差的 1 m 方格：</translation>
    </message>
    <message numerus="yes">
        <source>%1 views as expected</source>
        <translation>
            <numerusform>%1 个视图符合期望</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views differ</source>
        <translation>
            <numerusform>%1 个视图有差异</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views are over a limit</source>
        <translation>
            <numerusform>%1 个视图超过限值</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views have no expected picture</source>
        <translation>
            <numerusform>%1 个视图没有期望图像</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views failed</source>
        <translation>
            <numerusform>%1 个视图失败</numerusform>
        </translation>
    </message>
    <message>
        <source>as expected</source>
        <translation>符合期望</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>有差异</translation>
    </message>
    <message>
        <source>over a limit</source>
        <translation>超过限值</translation>
    </message>
    <message>
        <source>not expected yet</source>
        <translation>尚无期望图像</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>Other place</source>
        <translation>其他地点</translation>
    </message>
    <message>
        <source>Elevator</source>
        <translation>电梯</translation>
    </message>
    <message>
        <source>Charger</source>
        <translation>充电桩</translation>
    </message>
    <message>
        <source>Standby point</source>
        <translation>待命点</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>餐桌</translation>
    </message>
    <message>
        <source>Reception</source>
        <translation>接待点</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>Exchange point</source>
        <translation>交换点</translation>
    </message>
    <message>
        <source>Wait for elevator</source>
        <translation>候梯点</translation>
    </message>
    <message>
        <source>Dispatch point</source>
        <translation>调度点</translation>
    </message>
    <message>
        <source>Rack point</source>
        <translation>货架点</translation>
    </message>
    <message>
        <source>Docking point</source>
        <translation>对接点</translation>
    </message>
    <message>
        <source>Barcode</source>
        <translation>条码</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>路标</translation>
    </message>
    <message>
        <source>Virtual track</source>
        <translation>虚拟轨道</translation>
    </message>
    <message>
        <source>Virtual wall</source>
        <translation>虚拟墙</translation>
    </message>
    <message>
        <source>Guide line</source>
        <translation>引导线</translation>
    </message>
    <message>
        <source>Patrol path</source>
        <translation>巡逻路径</translation>
    </message>
    <message>
        <source>Forbidden region</source>
        <translation>禁行区</translation>
    </message>
    <message>
        <source>Slow zone</source>
        <translation>减速区</translation>
    </message>
    <message>
        <source>Automatic gate</source>
        <translation>自动闸机</translation>
    </message>
    <message>
        <source>Automatic door</source>
        <translation>自动门</translation>
    </message>
    <message>
        <source>Drop risk</source>
        <translation>跌落风险区</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>坡道</translation>
    </message>
    <message>
        <source>LiDAR deceitful area</source>
        <translation>激光雷达干扰区</translation>
    </message>
    <message>
        <source>Narrow passage</source>
        <translation>窄通道</translation>
    </message>
    <message>
        <source>Exclusive region</source>
        <translation>独占区</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>空闲区</translation>
    </message>
    <message>
        <source>Charging region</source>
        <translation>充电区</translation>
    </message>
    <message>
        <source>Depth restricted</source>
        <translation>深度受限区</translation>
    </message>
    <message>
        <source>Along centre line</source>
        <translation>居中行驶区</translation>
    </message>
    <message>
        <source>Rack zone</source>
        <translation>货架区</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线</translation>
    </message>
</context>
<context>
    <name>OverlayText</name>
    <message>
        <source>no place</source>
        <translation>无位置</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1，自 %2 起</translation>
    </message>
    <message numerus="yes">
        <source>%1 points</source>
        <translation>
            <numerusform>%1 个点</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1（位于 %2）</translation>
    </message>
    <message>
        <source>Move %1 by %2 m</source>
        <translation>将 %1 移动 %2 m</translation>
    </message>
    <message>
        <source>%1 moved by %2 m</source>
        <translation>%1 移动了 %2 m</translation>
    </message>
    <message>
        <source>Reshape %1</source>
        <translation>改变 %1 的形状</translation>
    </message>
    <message>
        <source>%1 has another shape</source>
        <translation>%1 的形状变了</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>将 %1 重命名为 %2</translation>
    </message>
    <message>
        <source>%1 is called %2 now</source>
        <translation>%1 现在名称为 %2</translation>
    </message>
    <message>
        <source>Make %1 a %2</source>
        <translation>将 %1 改为%2</translation>
    </message>
    <message>
        <source>%1 became a %2</source>
        <translation>%1 变成了%2</translation>
    </message>
    <message>
        <source>Turn %1 to %2 (was %3)</source>
        <translation>将 %1 旋转到 %2（原为 %3）</translation>
    </message>
    <message>
        <source>%1 turned from %3 to %2</source>
        <translation>%1 由 %3 旋转到 %2</translation>
    </message>
    <message>
        <source>Set %1 of %2 to %3</source>
        <translation>将 %2 的 %1 设为 %3</translation>
    </message>
    <message>
        <source>%1 of %2 is %3 now</source>
        <translation>%2 的 %1 现在为 %3</translation>
    </message>
    <message>
        <source>Set %1 of %2 to %3 (was %4)</source>
        <translation>将 %2 的 %1 设为 %3（原为 %4）</translation>
    </message>
    <message>
        <source>%1 of %2 went from %4 to %3</source>
        <translation>%2 的 %1 由 %4 变为 %3</translation>
    </message>
    <message>
        <source>Remove %1 of %2 (was %3)</source>
        <translation>移除 %2 的 %1（原为 %3）</translation>
    </message>
    <message>
        <source>%1 of %2 is gone (was %3)</source>
        <translation>%2 的 %1 已消失（原为 %3）</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>要素</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>（无名称）</translation>
    </message>
    <message numerus="yes">
        <source>%1 features</source>
        <translation>
            <numerusform>%1 个要素</numerusform>
        </translation>
    </message>
    <message>
        <source>(no id)</source>
        <translation>（无 id）</translation>
    </message>
    <message>
        <source>the collection</source>
        <translation>整个集合</translation>
    </message>
    <message numerus="yes">
        <source>%1 changes</source>
        <translation>
            <numerusform>%1 项更改</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 改为 %2</translation>
    </message>
    <message>
        <source>Change the defaults of the map: %1</source>
        <translation>更改地图的默认值：%1</translation>
    </message>
    <message>
        <source>the defaults of the map changed: %1</source>
        <translation>地图的默认值变了：%1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>%1 is new</source>
        <translation>%1 是新的</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 已消失</translation>
    </message>
    <message>
        <source>all of it</source>
        <translation>全部内容</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>default width of racks</source>
        <translation>货架默认宽度</translation>
    </message>
    <message>
        <source>default depth of racks</source>
        <translation>货架默认深度</translation>
    </message>
    <message>
        <source>default width of pallets</source>
        <translation>托盘默认宽度</translation>
    </message>
    <message>
        <source>default depth of pallets</source>
        <translation>托盘默认深度</translation>
    </message>
    <message>
        <source>deleted</source>
        <translation>已删除</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>kept, with changes</source>
        <translation>保留，但有更改</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>en</source>
        <translation>zh-CN</translation>
    </message>
</context>
<context>
    <name>Placing</name>
    <message>
        <source>It is in a wall.</source>
        <translation>它在墙中。</translation>
    </message>
    <message>
        <source>It is outside the map.</source>
        <translation>它在地图外。</translation>
    </message>
    <message>
        <source>It is %1 m from a wall: closer than the robot&apos;s radius of %2 m.</source>
        <translation>它距墙 %1 m：小于机器人半径 %2 m。</translation>
    </message>
    <message>
        <source>It is in an unknown part of the map.</source>
        <translation>它在地图的未知部分。</translation>
    </message>
    <message>
        <source>Another waypoint has the same name.</source>
        <translation>另一个路径点有相同的名称。</translation>
    </message>
    <message>
        <source>Its orientation is a zero quaternion, so it has no heading: turn it.</source>
        <translation>其方向是零四元数，因此没有朝向：请旋转它。</translation>
    </message>
    <message>
        <source>Its name looks temporary: a swap of names was interrupted.</source>
        <translation>其名称像是临时的：名称互换曾被中断。</translation>
    </message>
    <message>
        <source>There is no map below: walls are not checked.</source>
        <translation>下面没有地图：未检查墙。</translation>
    </message>
    <message>
        <source>The map below is unknown everywhere: walls cannot be checked.</source>
        <translation>下面的地图全是未知：无法检查墙。</translation>
    </message>
</context>
<context>
    <name>ProblemLog</name>
    <message>
        <source>info</source>
        <translation>信息</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>d</source>
        <translation>d</translation>
    </message>
    <message>
        <source>%1 times since %2</source>
        <translation>自 %2 起 %1 次</translation>
    </message>
    <message>
        <source>resolved after %1</source>
        <translation>%1后已解决</translation>
    </message>
    <message numerus="yes">
        <source>%1 older problems are no longer listed.</source>
        <translation>
            <numerusform>另有 %1 个较早的问题不再列出。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Punctuation</name>
    <message>
        <source>, </source>
        <comment>between the words of a list</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>; </source>
        <comment>between clauses</comment>
        <translation>；</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a subject, and what is said of it</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>.</source>
        <comment>the end of a sentence</comment>
        <translation>。</translation>
    </message>
</context>
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>%1 File</source>
        <translation>%1 文件</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>全选(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>增大(&amp;S)</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>减小(&amp;D)</translation>
    </message>
</context>
<context>
    <name>QColorDialog</name>
    <message>
        <source>Hu&amp;e:</source>
        <translation>色相(&amp;E)：</translation>
    </message>
    <message>
        <source>&amp;Sat:</source>
        <translation>饱和度(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Val:</source>
        <translation>明度(&amp;V)：</translation>
    </message>
    <message>
        <source>&amp;Red:</source>
        <translation>红(&amp;R)：</translation>
    </message>
    <message>
        <source>&amp;Green:</source>
        <translation>绿(&amp;G)：</translation>
    </message>
    <message>
        <source>Bl&amp;ue:</source>
        <translation>蓝(&amp;U)：</translation>
    </message>
    <message>
        <source>A&amp;lpha channel:</source>
        <translation>不透明度(&amp;L)：</translation>
    </message>
    <message>
        <source>&amp;HTML:</source>
        <translation>&amp;HTML：</translation>
    </message>
    <message>
        <source>&amp;Basic colors</source>
        <translation>基本颜色(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Custom colors</source>
        <translation>自定义颜色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Add to Custom Colors</source>
        <translation>添加到自定义颜色(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Pick Screen Color</source>
        <translation>屏幕取色(&amp;P)</translation>
    </message>
    <message>
        <source>Select Color</source>
        <translation>选择颜色</translation>
    </message>
    <message>
        <source>Cursor at %1, %2
Press ESC to cancel</source>
        <translation>光标位于 %1，%2
按 Esc 取消</translation>
    </message>
</context>
<context>
    <name>QDialog</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>QDialogButtonBox</name>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>查找位置：</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>上级文件夹</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>转到上级文件夹</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>新建文件夹</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>新建文件夹</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>列表视图</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>切换为列表视图</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>详细视图</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>切换为详细视图</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>侧栏</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>位置和书签列表</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>文件类型：</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>查找文件夹</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>另存为</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>选择(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>显示 </translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>显示隐藏文件(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>新建文件夹(&amp;N)</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>新建文件夹</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>文件夹：</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>文件名(&amp;N)：</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>最近的位置</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
找不到该文件夹。
请检查文件夹名称是否正确。</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 已存在。
要替换它吗？</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
找不到该文件。
请检查文件名是否正确。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write protected.
Do you want to delete it anyway?</source>
        <translation>“%1”有写保护。
仍要删除吗？</translation>
    </message>
    <message>
        <source>Are you sure you want to delete &apos;%1&apos;?</source>
        <translation>确定要删除“%1”吗？</translation>
    </message>
    <message>
        <source>Could not delete directory.</source>
        <translation>无法删除该文件夹。</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>修改日期</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>计算机</translation>
    </message>
</context>
<context>
    <name>QGnomeTheme</name>
    <message>
        <source>&amp;OK</source>
        <translation>确定(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Close without Saving</source>
        <translation>不保存并关闭</translation>
    </message>
</context>
<context>
    <name>QIODevice</name>
    <message>
        <source>No such file or directory</source>
        <translation>没有这个文件或文件夹</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>权限不足</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间不足</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>打开的文件过多</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>它是文件夹</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>它不是文件夹</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>文件已存在</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>文件名过长</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>文件系统是只读的</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>输入/输出错误</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>不允许该操作</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>超出磁盘配额</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>连接被拒绝</translation>
    </message>
    <message>
        <source>Broken pipe</source>
        <translation>管道已断开</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>全选</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Show Details...</source>
        <translation>显示详情…</translation>
    </message>
    <message>
        <source>Hide Details...</source>
        <translation>隐藏详情…</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>是(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>否(&amp;N)</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>中止</translation>
    </message>
</context>
<context>
    <name>QScrollBar</name>
    <message>
        <source>Scroll here</source>
        <translation>滚动到此处</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>最左</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>最上</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>最右</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>最下</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>向左一页</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>向上一页</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>向右一页</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>向下一页</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>向左滚动</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>向上滚动</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>向右滚动</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>向下滚动</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>复制链接地址(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>全选</translation>
    </message>
</context>
<context>
    <name>Quality</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>%1 and %2°: submap %3, node %4 at %5, by the closure at %6</source>
        <translation>%1 和 %2°：子图 %3，节点 %4，位于 %5，回环在 %6</translation>
    </message>
    <message numerus="yes">
        <source>%1 cells at %2, submaps %3</source>
        <translation>
            <numerusform>%1 个栅格，位于 %2，子图 %3</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>loop closures</source>
        <translation>回环</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>largest residual</source>
        <translation>最大残差</translation>
    </message>
    <message>
        <source>share</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>contradicted cells</source>
        <translation>矛盾的栅格</translation>
    </message>
    <message>
        <source>occupied cells</source>
        <translation>占据栅格</translation>
    </message>
    <message>
        <source>tolerance in cells</source>
        <translation>容差（栅格数）</translation>
    </message>
    <message>
        <source>constraints that could not be judged</source>
        <translation>无法评判的约束</translation>
    </message>
    <message>
        <source>Loop closures that contradict the finished map by more than %1: %2 of %3.</source>
        <translation>与最终地图矛盾超过 %1 的回环：%2 / %3。</translation>
    </message>
    <message>
        <source>Submaps contradict each other in %1 of the occupied cells, more than %2.</source>
        <translation>子图在 %1 的占据栅格中相互矛盾，超过 %2。</translation>
    </message>
    <message>
        <source>Loop closures: %1, at least %2 are wanted.</source>
        <translation>回环：%1，至少需要 %2。</translation>
    </message>
    <message>
        <source>No loop was closed, so there is nothing to hold against the limit of %1.</source>
        <translation>没有闭合任何回环，因此没有可与限值 %1 对照的内容。</translation>
    </message>
    <message>
        <source>SLAM session: %1.</source>
        <translation>SLAM 会话：%1。</translation>
    </message>
</context>
<context>
    <name>Regions</name>
    <message>
        <source>The answer does not say where it is, or how large its cells are.</source>
        <translation>应答没有说明它的位置，或其栅格的大小。</translation>
    </message>
    <message>
        <source>The answer has fewer cells than it should.</source>
        <translation>应答的栅格比应有的少。</translation>
    </message>
    <message>
        <source>The answer is in another frame than the regions before it.</source>
        <translation>应答的坐标系与之前的分块不同。</translation>
    </message>
    <message>
        <source>The answer is far larger than the requested region, and was ignored.</source>
        <translation>应答远大于所请求的分块，已忽略。</translation>
    </message>
    <message>
        <source>The robot answered with another region.</source>
        <translation>机器人应答的是另一个分块。</translation>
    </message>
</context>
<context>
    <name>RehearsalText</name>
    <message>
        <source>Its end can be reached from its start.</source>
        <translation>从起点可以到达终点。</translation>
    </message>
    <message>
        <source>Its end cannot be reached from its start on this map.</source>
        <translation>在该地图上，从起点无法到达终点。</translation>
    </message>
    <message>
        <source>The robot cannot drive where it starts.</source>
        <translation>机器人在起点处无法行驶。</translation>
    </message>
    <message>
        <source>The robot cannot drive where it ends.</source>
        <translation>机器人在终点处无法行驶。</translation>
    </message>
    <message>
        <source>free</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>outside of the map</source>
        <translation>在地图外</translation>
    </message>
    <message>
        <source>unknown to the map</source>
        <translation>地图未知</translation>
    </message>
    <message>
        <source>too close to a wall</source>
        <translation>离墙太近</translation>
    </message>
    <message>
        <source>in an obstacle</source>
        <translation>在障碍物中</translation>
    </message>
    <message>
        <source>It has no position of the robot.</source>
        <translation>其中没有机器人的位置。</translation>
    </message>
    <message>
        <source>%1 m %2</source>
        <translation>%1 m %2</translation>
    </message>
    <message>
        <source>%1 m, all free.</source>
        <translation>%1 m，全部空闲。</translation>
    </message>
    <message>
        <source>%1 m. Not free: %2.</source>
        <translation>%1 m。有问题的路段：%2。</translation>
    </message>
    <message>
        <source>Most of it lies where this map knows nothing: it may be of another place.</source>
        <translation>大部分位于该地图没有任何信息的地方：它可能来自另一个地点。</translation>
    </message>
    <message>
        <source>Jumps and pauses, where the way is not known: %1.</source>
        <translation>路径不明的跳变和停顿：%1。</translation>
    </message>
    <message>
        <source>Positions left out because they are no numbers: %1.</source>
        <translation>因不是数字而略去的位置：%1。</translation>
    </message>
    <message>
        <source>Driven on another map, not rehearsed: %1 m.</source>
        <translation>在另一张地图上行驶，未预演：%1 m。</translation>
    </message>
    <message>
        <source>By what is recorded, it was driven on another map.</source>
        <translation>根据录制内容，它是在另一张地图上行驶的。</translation>
    </message>
    <message>
        <source>The robot was on several maps, and which of them is meant is not known: the part that fits best is rehearsed.</source>
        <translation>机器人曾在多张地图上，无法得知指的是哪一张：预演最吻合的那一段。</translation>
    </message>
</context>
<context>
    <name>SeenObjects</name>
    <message>
        <source>person</source>
        <translation>人</translation>
    </message>
    <message>
        <source>platform hand truck</source>
        <translation>平板推车</translation>
    </message>
    <message>
        <source>scaffold</source>
        <translation>脚手架</translation>
    </message>
    <message>
        <source>queue stand</source>
        <translation>排队隔离柱</translation>
    </message>
    <message>
        <source>portable grandstand</source>
        <translation>移动看台</translation>
    </message>
    <message>
        <source>rack (aligned)</source>
        <translation>货架（已对齐）</translation>
    </message>
    <message>
        <source>rack</source>
        <translation>货架</translation>
    </message>
</context>
<context>
    <name>SetPose</name>
    <message>
        <source>Setting a map or a pose tells the robot where it is. If it is wrong, the robot drives into things.</source>
        <translation>设置地图或位姿会告诉机器人它在哪里。如果设置错误，机器人会撞上东西。</translation>
    </message>
    <message>
        <source>A pose is three numbers: x and y in metres, and the heading.</source>
        <translation>位姿是三个数字：x 和 y，单位为米，以及朝向。</translation>
    </message>
    <message>
        <source>The pose is more than 10,000 km away from the origin of the map.</source>
        <translation>该位姿距地图原点超过 10,000 km。</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3°</source>
        <translation>x %1 m，y %2 m，%3°</translation>
    </message>
    <message>
        <source>The robot accepted the pose, but says that it is at %1: %2 m and %3° from the pose that was set.</source>
        <translation>机器人接受了位姿，但报告自己位于 %1：与所设位姿相差 %2 m 和 %3°。</translation>
    </message>
    <message>
        <source>The robot says that it is at %1: it adjusted the pose by %2 m and %3°.</source>
        <translation>机器人报告自己位于 %1：它将位姿修正了 %2 m 和 %3°。</translation>
    </message>
    <message>
        <source>The robot says that it is at %1: %2 m and %3° from the pose that was set.</source>
        <translation>机器人报告自己位于 %1：与所设位姿相差 %2 m 和 %3°。</translation>
    </message>
    <message>
        <source> (score %1)</source>
        <translation> （得分 %1）</translation>
    </message>
    <message>
        <source>The robot found itself at %1%2.</source>
        <translation>机器人重定位成功，位于 %1%2。</translation>
    </message>
    <message>
        <source>The robot may be at %1%2. It does not use this pose yet: confirm it.</source>
        <translation>机器人可能位于 %1%2。它尚未采用该结果：请确认。</translation>
    </message>
    <message>
        <source>The robot did not find itself.</source>
        <translation>机器人重定位失败。</translation>
    </message>
    <message>
        <source>The robot did not find itself: %1</source>
        <translation>机器人重定位失败：%1</translation>
    </message>
</context>
<context>
    <name>SimulateOptions</name>
    <message>
        <source>Port of the Autoxing robot, 0 for any free port</source>
        <translation>Autoxing 机器人的端口，0 表示任意空闲端口</translation>
    </message>
    <message>
        <source>Port of the Agibot robot, 0 for any free port</source>
        <translation>Agibot 机器人的端口，0 表示任意空闲端口</translation>
    </message>
    <message>
        <source>The Agibot robot has newer firmware: its maps and waypoints can be changed, and it can map</source>
        <translation>Agibot 机器人使用较新的固件：可以更改其地图和路径点，也可以建图</translation>
    </message>
    <message>
        <source>The resolution of the Agibot robot&apos;s maps means centimetres per pixel</source>
        <translation>Agibot 机器人地图的分辨率表示每像素厘米数</translation>
    </message>
    <message>
        <source>One of: %1</source>
        <translation>可选：%1</translation>
    </message>
    <message>
        <source>there is no scene &quot;%1&quot;</source>
        <translation>没有场景“%1”</translation>
    </message>
    <message>
        <source>Approximate number of submaps (0 = as in the scene); beyond 20,000 they share 256 pictures</source>
        <translation>子图的大致数量（0 = 按场景）；超过 20,000 时共用 256 张图像</translation>
    </message>
    <message>
        <source>Seed of everything random</source>
        <translation>所有随机内容的种子</translation>
    </message>
    <message>
        <source>Simulated seconds per real second</source>
        <translation>每真实秒对应的模拟秒数</translation>
    </message>
    <message>
        <source>Simulated time at the start, seconds</source>
        <translation>开始时的模拟时间，单位为秒</translation>
    </message>
    <message>
        <source>Stop the simulated clock</source>
        <translation>停止模拟时钟</translation>
    </message>
    <message>
        <source>File with the secret without which the Autoxing robot answers 401</source>
        <translation>密钥文件；没有该密钥时 Autoxing 机器人应答 401</translation>
    </message>
    <message>
        <source>Accept enable_topic for only one topic at a time</source>
        <translation>enable_topic 一次只接受一个话题</translation>
    </message>
    <message>
        <source>Add bags of eight hours, with a clock set back, with equal stamps, with a gap, with one message and with none; damaged ones, one that is not counted, and one of all that robots latch</source>
        <translation>添加八小时的数据包：时钟回拨的、时间戳相同的、有间断的、只有一条消息的和没有消息的；损坏的、未计数的，以及包含机器人锁存的全部内容的</translation>
    </message>
    <message>
        <source>A range request for a bag stops before end_time</source>
        <translation>对数据包的范围请求在 end_time 之前停止</translation>
    </message>
    <message>
        <source>Downloads cannot be resumed</source>
        <translation>下载不能续传</translation>
    </message>
    <message>
        <source>Ignore ?pb=1</source>
        <translation>忽略 ?pb=1</translation>
    </message>
    <message>
        <source>What global positioning finds has to be confirmed</source>
        <translation>全局定位的结果必须经过确认</translation>
    </message>
    <message>
        <source>Lidar points per scan</source>
        <translation>每次扫描的激光雷达点数</translation>
    </message>
    <message>
        <source>Scans per second</source>
        <translation>每秒扫描次数</translation>
    </message>
    <message>
        <source>Poses per second</source>
        <translation>每秒位姿数</translation>
    </message>
    <message>
        <source>Edge length of the costmaps around the robot, in cells</source>
        <translation>机器人周围代价地图的边长，单位为栅格</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Delay of every submap response</source>
        <translation>每个子图应答的延迟</translation>
    </message>
    <message>
        <source>Random extra delay</source>
        <translation>随机的额外延迟</translation>
    </message>
    <message>
        <source>Share of submap requests that get no response</source>
        <translation>得不到应答的子图请求的比例</translation>
    </message>
    <message>
        <source>Share of responses cut off half-way</source>
        <translation>中途被截断的应答的比例</translation>
    </message>
    <message>
        <source>Share of responses whose width and height do not match the cells</source>
        <translation>宽高与栅格不符的应答的比例</translation>
    </message>
    <message>
        <source>Share of responses that are garbage</source>
        <translation>内容为乱码的应答的比例</translation>
    </message>
    <message>
        <source>HTTP status of the responses of --error-rate</source>
        <translation>--error-rate 所指应答的 HTTP 状态</translation>
    </message>
    <message>
        <source>Share of responses with --error-status</source>
        <translation>带有 --error-status 的应答的比例</translation>
    </message>
    <message>
        <source>Share of HTTP 200 responses that contain an error status</source>
        <translation>内含错误状态的 HTTP 200 应答的比例</translation>
    </message>
    <message>
        <source>Close the WebSocket every so many seconds</source>
        <translation>每隔这么多秒关闭 WebSocket</translation>
    </message>
    <message>
        <source>Restart SLAM every so many seconds</source>
        <translation>每隔这么多秒重启 SLAM</translation>
    </message>
    <message>
        <source>List NaN poses, zero quaternions, duplicates and decreasing versions</source>
        <translation>列出 NaN 位姿、零四元数、重复项和递减的版本</translation>
    </message>
    <message>
        <source>Accept the WebSocket, then send nothing</source>
        <translation>接受 WebSocket，然后什么都不发送</translation>
    </message>
    <message>
        <source>Delay of every response to a change: POST, PUT, PATCH, DELETE, and calls that change something</source>
        <translation>每个更改类应答的延迟：POST、PUT、PATCH、DELETE，以及会更改内容的调用</translation>
    </message>
    <message>
        <source>Only changes of this path or service, and of what is below it, go wrong, for example /maps/</source>
        <translation>只让该路径或服务及其下级的更改出错，例如 /maps/</translation>
    </message>
    <message>
        <source>Share of these that change nothing and get 500, 502 or 503</source>
        <translation>其中不更改任何内容并得到 500、502 或 503 的比例</translation>
    </message>
    <message>
        <source>Share of these that change nothing and get no response</source>
        <translation>其中不更改任何内容且得不到应答的比例</translation>
    </message>
    <message>
        <source>Share of these that take effect but get no response</source>
        <translation>其中已生效但得不到应答的比例</translation>
    </message>
    <message>
        <source>Share of these that are answered as if all was well, but change nothing</source>
        <translation>其中应答一切正常但不更改任何内容的比例</translation>
    </message>
    <message>
        <source>A path or service that answers with an error and does nothing; may be repeated</source>
        <translation>应答错误且什么都不做的路径或服务；可重复使用</translation>
    </message>
    <message>
        <source>A path or service that does its work but never answers; may be repeated</source>
        <translation>完成工作但从不应答的路径或服务；可重复使用</translation>
    </message>
    <message>
        <source>A path or service that does its work, then closes the connection; may be repeated</source>
        <translation>完成工作后关闭连接的路径或服务；可重复使用</translation>
    </message>
    <message>
        <source>Share of .pbstream downloads that break off half-way</source>
        <translation>中途断开的 .pbstream 下载的比例</translation>
    </message>
    <message>
        <source>A topic that never publishes; may be repeated</source>
        <translation>从不发布的话题；可重复使用</translation>
    </message>
    <message>
        <source>The robot sees no charger, rack, pallet or trailer, and has collected no landmarks</source>
        <translation>机器人看不到充电桩、货架、托盘或拖车，也没有采集到路标</translation>
    </message>
    <message>
        <source>Someone else changes the overlays of the current map every so many seconds</source>
        <translation>每隔这么多秒由他人更改当前地图的覆盖物</translation>
    </message>
    <message>
        <source>Someone else changes the overlays right before each change of them</source>
        <translation>每次更改覆盖物之前都由他人抢先更改</translation>
    </message>
    <message>
        <source>Delay of every response about maps</source>
        <translation>每个地图相关应答的延迟</translation>
    </message>
    <message>
        <source>Cut off every map&apos;s PNG half-way</source>
        <translation>每张地图的 PNG 都中途截断</translation>
    </message>
    <message>
        <source>Every map&apos;s PNG declares 60,000 x 60,000 pixels</source>
        <translation>每张地图的 PNG 都声明为 60,000 x 60,000 像素</translation>
    </message>
    <message>
        <source>data_url points to another host</source>
        <translation>data_url 指向另一台主机</translation>
    </message>
    <message>
        <source>Pictures in topics are not valid base64</source>
        <translation>话题中的图像不是有效的 base64</translation>
    </message>
    <message>
        <source>Answer 500 for the list of maps</source>
        <translation>对地图列表应答 500</translation>
    </message>
    <message>
        <source>What is wrong with every map&apos;s place and resolution</source>
        <translation>每张地图的位置和分辨率有何错误</translation>
    </message>
    <message>
        <source>Port of the ROS robot, 0 for any free port</source>
        <translation>ROS 机器人的端口，0 表示任意空闲端口</translation>
    </message>
    <message>
        <source>ros1 or ros2: type names, times and headers</source>
        <translation>ros1 或 ros2：类型名称、时间和消息头</translation>
    </message>
    <message>
        <source>How to write JSON: escaped (\/ and \uXXXX), spaced or plain</source>
        <translation>JSON 的写法：escaped（\/ 和 \uXXXX）、spaced 或 plain</translation>
    </message>
    <message>
        <source>The ROS robot has no /rosapi</source>
        <translation>ROS 机器人没有 /rosapi</translation>
    </message>
    <message>
        <source>The ROS robot has no /map_manager</source>
        <translation>ROS 机器人没有 /map_manager</translation>
    </message>
    <message>
        <source>Report errors in status messages</source>
        <translation>在 status 消息中报告错误</translation>
    </message>
    <message>
        <source>Disconnect clients whose first message is not a complete auth message</source>
        <translation>首条消息不是完整的 auth 消息时断开客户端</translation>
    </message>
    <message>
        <source>Number of waypoints in the ROS robot&apos;s current map</source>
        <translation>ROS 机器人当前地图中的路径点数量</translation>
    </message>
    <message>
        <source>map_list includes archived maps</source>
        <translation>map_list 包含已归档的地图</translation>
    </message>
    <message>
        <source>Nothing is deleted unless delete_map or delete_waypoint is set</source>
        <translation>只有设置了 delete_map 或 delete_waypoint 才会删除</translation>
    </message>
    <message>
        <source>An update with an empty tag list leaves the tags unchanged</source>
        <translation>标签列表为空的更新不改变标签</translation>
    </message>
    <message>
        <source>Faults of the ROS robot</source>
        <translation>ROS 机器人的故障</translation>
    </message>
    <message>
        <source>Delay of every service response, milliseconds</source>
        <translation>每个服务应答的延迟，单位为毫秒</translation>
    </message>
    <message>
        <source>Every second response arrives after the ones that follow it</source>
        <translation>每隔一个应答都晚于其后的应答到达</translation>
    </message>
    <message>
        <source>/map, /scan and /odom have type std_msgs/String</source>
        <translation>/map、/scan 和 /odom 的类型为 std_msgs/String</translation>
    </message>
    <message>
        <source>Send messages in fragments of this many characters</source>
        <translation>将消息拆成这么多字符的片段发送</translation>
    </message>
    <message>
        <source>Close all connections to the ROS robot every so many seconds</source>
        <translation>每隔这么多秒关闭到 ROS 机器人的所有连接</translation>
    </message>
    <message>
        <source>Send frames that are not messages in between</source>
        <translation>在其间发送不是消息的帧</translation>
    </message>
    <message>
        <source>Another client changes waypoints and maps every so many seconds</source>
        <translation>每隔这么多秒由另一个客户端更改路径点和地图</translation>
    </message>
    <message>
        <source>The waypoint topic publishes changes this many milliseconds late</source>
        <translation>路径点话题延迟这么多毫秒发布更改</translation>
    </message>
    <message>
        <source>Another client paints on the current map every so many seconds</source>
        <translation>每隔这么多秒由另一个客户端在当前地图上涂画</translation>
    </message>
    <message>
        <source>update_map_image does nothing and returns this code</source>
        <translation>update_map_image 什么都不做，并返回该代码</translation>
    </message>
    <message>
        <source>update_map_image does nothing but reports success</source>
        <translation>update_map_image 什么都不做，但报告成功</translation>
    </message>
    <message>
        <source>Poses, transforms and some waypoints are NaN</source>
        <translation>位姿、变换和部分路径点为 NaN</translation>
    </message>
    <message>
        <source>Quaternions are zero or not normalized</source>
        <translation>四元数为零或未归一化</translation>
    </message>
    <message>
        <source>/tf has a loop</source>
        <translation>/tf 有环</translation>
    </message>
    <message>
        <source>/points is big-endian</source>
        <translation>/points 为大端序</translation>
    </message>
    <message>
        <source>Map dispatcher (REP 130) of the ROS robot</source>
        <translation>ROS 机器人的地图分发器 (REP 130)</translation>
    </message>
    <message>
        <source>It exists, but nobody publishes the map as a topic</source>
        <translation>它存在，但没有人将地图发布为话题</translation>
    </message>
    <message>
        <source>Edge length of its building in whole metres; 1000 gives 20,000 x 20,000 cells and 40 million points</source>
        <translation>其建筑的边长，单位为整米；1000 对应 20,000 x 20,000 栅格和 4000 万个点</translation>
    </message>
    <message>
        <source>Without get_map and get_sub_map</source>
        <translation>没有 get_map 和 get_sub_map</translation>
    </message>
    <message>
        <source>Without clouds and projections</source>
        <translation>没有点云和投影</translation>
    </message>
    <message>
        <source>set_map_projections has type ProjectedMapsInfo, so projections can be set</source>
        <translation>set_map_projections 的类型为 ProjectedMapsInfo，因此可以设置投影</translation>
    </message>
    <message>
        <source>It answers projected_maps instead of projected_maps_info</source>
        <translation>它应答 projected_maps，而不是 projected_maps_info</translation>
    </message>
    <message>
        <source>Its types come from map_msg</source>
        <translation>其类型来自 map_msg</translation>
    </message>
    <message>
        <source>What it returns for a region: pad, empty, rotated, elsewhere or corner</source>
        <translation>它对分块返回什么：pad、empty、rotated、elsewhere 或 corner</translation>
    </message>
    <message>
        <source>Maximum number of cells in the grid of a region, 0 for no limit</source>
        <translation>分块的栅格地图的最大栅格数，0 表示无限制</translation>
    </message>
    <message>
        <source>What it returns for a larger region: cut (the lower left part), empty or error</source>
        <translation>它对更大的分块返回什么：cut（左下部分）、empty 或 error</translation>
    </message>
    <message>
        <source>What is wrong with its clouds: point-step, row-step, width or data; with its grids: data or cells</source>
        <translation>其点云有何错误：point-step、row-step、width 或 data；其栅格地图有何错误：data 或 cells</translation>
    </message>
    <message>
        <source>Its clouds are big-endian</source>
        <translation>其点云为大端序</translation>
    </message>
    <message>
        <source>Its clouds have 64-bit coordinates</source>
        <translation>其点云使用 64 位坐标</translation>
    </message>
    <message>
        <source>The fields of its clouds are not aligned</source>
        <translation>其点云的字段未对齐</translation>
    </message>
    <message>
        <source>Its clouds have no z</source>
        <translation>其点云没有 z</translation>
    </message>
    <message>
        <source>Every tenth point of its clouds is NaN</source>
        <translation>其点云每第十个点为 NaN</translation>
    </message>
    <message>
        <source>Shift x and y of its clouds by this many metres</source>
        <translation>将其点云的 x 和 y 偏移这么多米</translation>
    </message>
    <message>
        <source>The resolution of its grids changes from call to call</source>
        <translation>其栅格地图的分辨率每次调用都不同</translation>
    </message>
    <message>
        <source>The layout of its grid changes every fourth call</source>
        <translation>其栅格地图的布局每四次调用变化一次</translation>
    </message>
    <message>
        <source>The secret file %1 holds no secret.</source>
        <translation>密钥文件 %1 中没有密钥。</translation>
    </message>
    <message>
        <source>Run a simulated robot on 127.0.0.1</source>
        <translation>在 127.0.0.1 上运行模拟机器人</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>a reason that it does not know</source>
        <translation>它不知道的原因</translation>
    </message>
    <message>
        <source>it has no map</source>
        <translation>它没有地图</translation>
    </message>
    <message>
        <source>the start lies outside of the map</source>
        <translation>起点在地图外</translation>
    </message>
    <message>
        <source>the target lies outside of the map</source>
        <translation>目标在地图外</translation>
    </message>
    <message>
        <source>the start is not on free ground</source>
        <translation>起点不在空闲区域</translation>
    </message>
    <message>
        <source>the target is not on free ground</source>
        <translation>目标不在空闲区域</translation>
    </message>
    <message>
        <source>start and target are the same</source>
        <translation>起点与目标相同</translation>
    </message>
    <message>
        <source>the details of the path could not be worked out</source>
        <translation>无法计算路径的细节</translation>
    </message>
    <message>
        <source>no road leads from the start to the target</source>
        <translation>没有从起点到目标的道路</translation>
    </message>
    <message>
        <source>working out the path took too long</source>
        <translation>计算路径用时过长</translation>
    </message>
    <message>
        <source>there is no path</source>
        <translation>没有路径</translation>
    </message>
    <message>
        <source>the start was not found on the path</source>
        <translation>在路径上找不到起点</translation>
    </message>
    <message>
        <source>the target was not found on the path</source>
        <translation>在路径上找不到目标</translation>
    </message>
    <message>
        <source>no way was found for too long</source>
        <translation>太久没有找到路径</translation>
    </message>
    <message>
        <source>a way was found, but driving took too long</source>
        <translation>找到了路径，但行驶用时过长</translation>
    </message>
    <message>
        <source>the data for avoiding obstacles is wrong, or a sensor is</source>
        <translation>避障数据错误，或传感器有错误</translation>
    </message>
    <message>
        <source>it is charging by a cable</source>
        <translation>正在通过线缆充电</translation>
    </message>
    <message>
        <source>turning took too long</source>
        <translation>旋转用时过长</translation>
    </message>
    <message>
        <source>it tried to dock at the charger too often</source>
        <translation>对接充电桩的尝试次数过多</translation>
    </message>
    <message>
        <source>it did not recognise the charger</source>
        <translation>没有识别到充电桩</translation>
    </message>
    <message>
        <source>the charger did not confirm the docking</source>
        <translation>充电桩没有确认对接</translation>
    </message>
    <message>
        <source>the place of the charger is not valid</source>
        <translation>充电桩的位置无效</translation>
    </message>
    <message>
        <source>it is charging already</source>
        <translation>已在充电</translation>
    </message>
    <message>
        <source>no current came from the charger</source>
        <translation>充电桩没有输出电流</translation>
    </message>
    <message>
        <source>the place of the cabinet is not valid</source>
        <translation>柜子的位置无效</translation>
    </message>
    <message>
        <source>it did not recognise the cabinet</source>
        <translation>没有识别到柜子</translation>
    </message>
    <message>
        <source>it is not docked at the conveyor</source>
        <translation>没有与输送线对接</translation>
    </message>
    <message>
        <source>it is not in front of the conveyor</source>
        <translation>不在输送线前面</translation>
    </message>
    <message>
        <source>the place in the elevator is taken</source>
        <translation>电梯内的位置已被占用</translation>
    </message>
    <message>
        <source>the elevator is closed</source>
        <translation>电梯门已关闭</translation>
    </message>
    <message>
        <source>the place in the elevator was out of sight for too long</source>
        <translation>太久看不到电梯内的位置</translation>
    </message>
    <message>
        <source>looking whether the place in the elevator is free took too long</source>
        <translation>判断电梯内的位置是否空闲用时过长</translation>
    </message>
    <message>
        <source>entering the elevator made no progress for too long</source>
        <translation>进入电梯时太久没有进展</translation>
    </message>
    <message>
        <source>the points of the track are not valid</source>
        <translation>轨道的点无效</translation>
    </message>
    <message>
        <source>it is too far from the start of the track</source>
        <translation>离轨道起点太远</translation>
    </message>
    <message>
        <source>the place to look for the rack from is not valid</source>
        <translation>寻找货架的位置无效</translation>
    </message>
    <message>
        <source>it did not recognise the rack</source>
        <translation>没有识别到货架</translation>
    </message>
    <message>
        <source>it tried to dock at the rack too often</source>
        <translation>对接货架的尝试次数过多</translation>
    </message>
    <message>
        <source>the place to unload at is taken</source>
        <translation>卸货位置已被占用</translation>
    </message>
    <message>
        <source>the place to unload at cannot be reached</source>
        <translation>无法到达卸货位置</translation>
    </message>
    <message>
        <source>the rack has moved</source>
        <translation>货架移动了</translation>
    </message>
    <message>
        <source>its jack is up</source>
        <translation>顶升处于升起状态</translation>
    </message>
    <message>
        <source>the id of the rack zone is not valid</source>
        <translation>货架区的 id 无效</translation>
    </message>
    <message>
        <source>the rack zone has no places</source>
        <translation>货架区没有货位</translation>
    </message>
    <message>
        <source>it does not know whether places of the rack zone are free</source>
        <translation>不知道货架区的货位是否空闲</translation>
    </message>
    <message>
        <source>there is no rack in the rack zone</source>
        <translation>货架区没有货架</translation>
    </message>
    <message>
        <source>it could not dock at a rack of the rack zone</source>
        <translation>无法与货架区的货架对接</translation>
    </message>
    <message>
        <source>the rack zone has no free place</source>
        <translation>货架区没有空闲货位</translation>
    </message>
    <message>
        <source>it could not unload in the rack zone</source>
        <translation>无法在货架区卸货</translation>
    </message>
    <message>
        <source>it lost whom it followed</source>
        <translation>丢失了跟随的人</translation>
    </message>
    <message>
        <source>it did not recognise the place</source>
        <translation>没有识别到该位置</translation>
    </message>
    <message>
        <source>the place cannot be reached</source>
        <translation>无法到达该位置</translation>
    </message>
    <message>
        <source>it did not recognise the barcode</source>
        <translation>没有识别到条码</translation>
    </message>
    <message>
        <source>something is wrong with the robot itself</source>
        <translation>机器人自身出现故障</translation>
    </message>
    <message>
        <source>a request to it was wrong</source>
        <translation>发给它的请求有误</translation>
    </message>
    <message>
        <source>its program found itself in error</source>
        <translation>其程序检测到自身错误</translation>
    </message>
    <message>
        <source>its map was changed or taken away meanwhile</source>
        <translation>其地图在此期间被更改或移走</translation>
    </message>
    <message>
        <source>it does not know this kind of task any more</source>
        <translation>它不再支持这种任务</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>较差</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>excellent</source>
        <translation>极好</translation>
    </message>
    <message>
        <source>quality %1</source>
        <translation>质量 %1</translation>
    </message>
    <message>
        <source>state unknown</source>
        <translation>状态未知</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>driving to its target</source>
        <translation>正在驶向目标</translation>
    </message>
    <message>
        <source>arrived</source>
        <translation>已到达</translation>
    </message>
    <message>
        <source>failed to get there</source>
        <translation>未能到达</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>正在打开</translation>
    </message>
    <message>
        <source>closing</source>
        <translation>正在关闭</translation>
    </message>
    <message>
        <source>charging</source>
        <translation>充电中</translation>
    </message>
    <message>
        <source>discharging</source>
        <translation>放电中</translation>
    </message>
    <message>
        <source>full</source>
        <translation>已充满</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>remote</source>
        <translation>遥控</translation>
    </message>
    <message>
        <source>positioning</source>
        <translation>定位</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>移动中</translation>
    </message>
    <message>
        <source>succeeded</source>
        <translation>成功</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>awake</source>
        <translation>已唤醒</translation>
    </message>
    <message>
        <source>awakening</source>
        <translation>正在唤醒</translation>
    </message>
    <message>
        <source>sleeping</source>
        <translation>休眠</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>jacking_up</source>
        <translation>正在顶升</translation>
    </message>
    <message>
        <source>jacking_down</source>
        <translation>正在下降</translation>
    </message>
</context>
<context>
    <name>Subject</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>File %1</source>
        <translation>文件 %1</translation>
    </message>
    <message>
        <source>Map &quot;%1&quot;</source>
        <translation>地图“%1”</translation>
    </message>
    <message>
        <source>Live map</source>
        <translation>实时地图</translation>
    </message>
    <message>
        <source>Mapping %1</source>
        <translation>建图 %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>地图 %1</translation>
    </message>
    <message>
        <source>Maps</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>Mappings</source>
        <translation>建图记录</translation>
    </message>
    <message>
        <source>Current map</source>
        <translation>当前地图</translation>
    </message>
    <message>
        <source>Bags</source>
        <translation>数据包</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>录制文件</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Lost position</source>
        <translation>位置丢失</translation>
    </message>
    <message>
        <source>Released wheels</source>
        <translation>轮子已释放</translation>
    </message>
    <message>
        <source>Manual control</source>
        <translation>手动控制</translation>
    </message>
    <message>
        <source>Uncertain position</source>
        <translation>位置不确定</translation>
    </message>
    <message>
        <source>Slipping wheels</source>
        <translation>轮子打滑</translation>
    </message>
    <message>
        <source>Alert</source>
        <translation>告警</translation>
    </message>
    <message>
        <source>Alert %1</source>
        <translation>告警 %1</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation>机器人 %1</translation>
    </message>
    <message>
        <source>Waypoints of %1</source>
        <translation>%1 的路径点</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>总览图</translation>
    </message>
    <message>
        <source>Submap list</source>
        <translation>子图列表</translation>
    </message>
    <message>
        <source>Submap %1</source>
        <translation>子图 %1</translation>
    </message>
    <message>
        <source>Memory for submaps</source>
        <translation>子图内存</translation>
    </message>
    <message>
        <source>Topic %1</source>
        <translation>话题 %1</translation>
    </message>
    <message>
        <source>Disk cache</source>
        <translation>磁盘缓存</translation>
    </message>
    <message>
        <source>Bag %1</source>
        <translation>数据包 %1</translation>
    </message>
    <message>
        <source>map dispatcher (REP 130)</source>
        <translation>地图分发器 (REP 130)</translation>
    </message>
</context>
<context>
    <name>SuitePage</name>
    <message>
        <source>Expected</source>
        <translation>期望</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>实际</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>What differs, in a strong colour; clusters in boxes.</source>
        <translation>有差异之处，以醒目颜色显示；聚簇加框。</translation>
    </message>
    <message>
        <source>Box in pixels</source>
        <translation>框（像素）</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>At, in metres</source>
        <translation>位置（米）</translation>
    </message>
    <message>
        <source>What changed there</source>
        <translation>那里的变化</translation>
    </message>
    <message>
        <source>Changed as well</source>
        <translation>同时变化</translation>
    </message>
    <message>
        <source>Changed there or elsewhere</source>
        <translation>那里或别处的变化</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>别处的变化</translation>
    </message>
    <message>
        <source>SLAM session</source>
        <translation>SLAM 会话</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Loop closures over the limit</source>
        <translation>超过限值的回环</translation>
    </message>
    <message>
        <source>Where submaps contradict each other most</source>
        <translation>子图相互矛盾最大的地方</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>所有视图</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>还有 %1 个未列出。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SuiteText</name>
    <message>
        <source>The key &quot;%1&quot; stands here twice.</source>
        <translation>键“%1”在此出现了两次。</translation>
    </message>
    <message>
        <source>%1 must be a text or a number.</source>
        <translation>%1 必须是文本或数字。</translation>
    </message>
    <message>
        <source>%1 has no value.</source>
        <translation>%1 没有值。</translation>
    </message>
    <message>
        <source>%1 is too long: at most %2 entries and %3 bytes.</source>
        <translation>%1 太长：最多 %2 项和 %3 字节。</translation>
    </message>
    <message>
        <source>%1 must be true or false.</source>
        <translation>%1 必须是 true 或 false。</translation>
    </message>
    <message>
        <source>%1 must be a number from 0 to %2.</source>
        <translation>%1 必须是 0 到 %2 的数字。</translation>
    </message>
    <message>
        <source>%1 must be a whole number.</source>
        <translation>%1 必须是整数。</translation>
    </message>
    <message>
        <source>quality must be limits with their values, or false.</source>
        <translation>quality 必须是带值的限值，或 false。</translation>
    </message>
    <message>
        <source>A key</source>
        <translation>键</translation>
    </message>
    <message>
        <source>There is no key &quot;%1&quot; of quality. Known: %2.</source>
        <translation>quality 没有键“%1”。已知：%2。</translation>
    </message>
    <message>
        <source>quality needs closures_over_m, disagreement_over or both.</source>
        <translation>quality 需要 closures_over_m、disagreement_over 或两者。</translation>
    </message>
    <message>
        <source>closures_at_least means nothing without closures_over_m.</source>
        <translation>没有 closures_over_m 时，closures_at_least 没有意义。</translation>
    </message>
    <message>
        <source>tolerance_cells means nothing without disagreement_over.</source>
        <translation>没有 disagreement_over 时，tolerance_cells 没有意义。</translation>
    </message>
    <message>
        <source>The name of this view is empty.</source>
        <translation>该视图的名称是空的。</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; would leave the folder or be hidden in it: leave out /, \ and a dot at the beginning.</source>
        <translation>名称“%1”会超出文件夹或在其中被隐藏：请去掉 /、\ 和开头的点。</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; has blanks around it, or characters that cannot be seen.</source>
        <translation>名称“%1”前后有空格，或含有不可见字符。</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is too long for a file: at most %2 bytes.</source>
        <translation>名称“%1”作为文件名太长：最多 %2 字节。</translation>
    </message>
    <message>
        <source>A name cannot be a default: each view has its own.</source>
        <translation>名称不能作为默认值：每个视图有自己的名称。</translation>
    </message>
    <message>
        <source>There is no key &quot;%1&quot; of a view. Known: %2.</source>
        <translation>视图没有键“%1”。已知：%2。</translation>
    </message>
    <message>
        <source>The view &quot;%1&quot; is called like &quot;%2&quot; in line %3: their files would be the same.</source>
        <translation>视图“%1”与第 %3 行的“%2”同名：它们的文件会相同。</translation>
    </message>
    <message>
        <source>The picture of the view &quot;%1&quot; would be a variant of &quot;%2&quot; in line %3.</source>
        <translation>视图“%1”的图像会成为第 %3 行“%2”的变体。</translation>
    </message>
    <message>
        <source>This is no suite: it has no views.</source>
        <translation>这不是套件：其中没有视图。</translation>
    </message>
    <message>
        <source>There is no key &quot;%1&quot; here, only defaults and views.</source>
        <translation>这里没有键“%1”，只有 defaults 和 views。</translation>
    </message>
    <message>
        <source>The defaults must be keys with their values.</source>
        <translation>defaults 必须是带值的键。</translation>
    </message>
    <message>
        <source>There are more than %1 views.</source>
        <translation>视图超过 %1 个。</translation>
    </message>
    <message>
        <source>A view must be keys with their values.</source>
        <translation>视图必须是带值的键。</translation>
    </message>
    <message>
        <source>This view has no name.</source>
        <translation>该视图没有名称。</translation>
    </message>
    <message>
        <source>The values of all views up to here are more than %1 MiB, defaults counted in each.</source>
        <translation>到此为止所有视图的值超过 %1 MiB（每个视图都计入默认值）。</translation>
    </message>
    <message>
        <source>It is larger than %1 MiB.</source>
        <translation>它大于 %1 MiB。</translation>
    </message>
    <message>
        <source>It has too many values; an alias counts as what it stands for.</source>
        <translation>其值太多；别名按其所代表的内容计算。</translation>
    </message>
    <message>
        <source>It is nested too deeply.</source>
        <translation>其嵌套太深。</translation>
    </message>
    <message>
        <source>It is not YAML: %1.</source>
        <translation>它不是 YAML：%1。</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>第 %1 行，第 %2 列：%3</translation>
    </message>
    <message>
        <source>A second document begins here: a suite is one. Leave out the ---.</source>
        <translation>这里开始了第二个文档：一个套件只能有一个文档。请去掉 ---。</translation>
    </message>
</context>
<context>
    <name>TimelineEvents</name>
    <message>
        <source>Alert %1</source>
        <translation>告警 %1</translation>
    </message>
    <message>
        <source>Alert %1: %2</source>
        <translation>告警 %1：%2</translation>
    </message>
    <message>
        <source>Alert %1 ended</source>
        <translation>告警 %1 结束</translation>
    </message>
    <message>
        <source>Alert %1 ended: %2</source>
        <translation>告警 %1 结束：%2</translation>
    </message>
    <message>
        <source>Planner: idle</source>
        <translation>规划器：空闲</translation>
    </message>
    <message>
        <source>Planner: %1</source>
        <translation>规划器：%1</translation>
    </message>
    <message>
        <source>The position jumped by %1 m</source>
        <translation>位置跳变了 %1 m</translation>
    </message>
    <message>
        <source>Map changed: %1</source>
        <translation>地图已更换：%1</translation>
    </message>
    <message>
        <source>New SLAM session</source>
        <translation>新的 SLAM 会话</translation>
    </message>
    <message>
        <source>Localization is poor or lost</source>
        <translation>定位较差或丢失</translation>
    </message>
    <message>
        <source>Localization is good again</source>
        <translation>定位恢复良好</translation>
    </message>
    <message>
        <source>Emergency stop pressed</source>
        <translation>急停已按下</translation>
    </message>
    <message>
        <source>Emergency stop released</source>
        <translation>急停已释放</translation>
    </message>
    <message>
        <source>Alert</source>
        <translation>告警</translation>
    </message>
    <message>
        <source>Alert ended</source>
        <translation>告警结束</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>规划器</translation>
    </message>
    <message>
        <source>Position jump</source>
        <translation>位置跳变</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>SLAM session</source>
        <translation>SLAM 会话</translation>
    </message>
    <message>
        <source>Localization poor</source>
        <translation>定位较差</translation>
    </message>
    <message>
        <source>Localization good</source>
        <translation>定位良好</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Stop released</source>
        <translation>急停释放</translation>
    </message>
    <message>
        <source>Alerts</source>
        <translation>告警</translation>
    </message>
    <message>
        <source>States of the planner</source>
        <translation>规划器状态</translation>
    </message>
    <message>
        <source>Localization: jumps, poor and good again</source>
        <translation>定位：跳变、较差和恢复良好</translation>
    </message>
    <message>
        <source>Maps and SLAM sessions</source>
        <translation>地图和 SLAM 会话</translation>
    </message>
    <message>
        <source>Emergency stops</source>
        <translation>急停</translation>
    </message>
</context>
<context>
    <name>TrackLayer</name>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>poor or lost</source>
        <translation>较差或丢失</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>一般</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>UnsavedQuestion</name>
    <message>
        <source>Keep as draft</source>
        <translation>保留为草稿</translation>
    </message>
    <message>
        <source>They will be offered when you open this map again</source>
        <translation>再次打开该地图时会提示恢复</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>今天 %1</translation>
    </message>
    <message>
        <source>d MMMM yyyy HH:mm</source>
        <translation>yyyy年M月d日 HH:mm</translation>
    </message>
</context>
<context>
    <name>WaypointConflict</name>
    <message>
        <source>%1 was changed here and elsewhere</source>
        <translation>%1 在这里和别处都被修改过</translation>
    </message>
    <message>
        <source>Keep &amp;mine</source>
        <translation>保留我的(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Delete it, as I did</source>
        <translation>同我一样删除(&amp;D)</translation>
    </message>
    <message>
        <source>Take &amp;theirs</source>
        <translation>采用对方的(&amp;T)</translation>
    </message>
    <message>
        <source>Delete it, as &amp;they did</source>
        <translation>同对方一样删除(&amp;T)</translation>
    </message>
    <message>
        <source>Keep &amp;both</source>
        <translation>两者都保留(&amp;B)</translation>
    </message>
    <message>
        <source>keep mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>take theirs</source>
        <translation>采用对方的</translation>
    </message>
    <message>
        <source>keep %1 as well</source>
        <translation>同时保留 %1</translation>
    </message>
</context>
<context>
    <name>WaypointDeedText</name>
    <message>
        <source>Create %1</source>
        <translation>创建 %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>将 %1 重命名为 %2</translation>
    </message>
    <message>
        <source>Move %1 by %2 m</source>
        <translation>将 %1 移动 %2 m</translation>
    </message>
    <message>
        <source>move it by %1 m</source>
        <translation>将其移动 %1 m</translation>
    </message>
    <message>
        <source>Remove the heading of %1</source>
        <translation>移除 %1 的朝向</translation>
    </message>
    <message>
        <source>remove its heading</source>
        <translation>移除其朝向</translation>
    </message>
    <message>
        <source>Turn %1 to %2</source>
        <translation>将 %1 旋转到 %2</translation>
    </message>
    <message>
        <source>turn it to %1</source>
        <translation>将其旋转到 %1</translation>
    </message>
    <message>
        <source>Turn %1 by %2</source>
        <translation>将 %1 旋转 %2</translation>
    </message>
    <message>
        <source>turn it by %1</source>
        <translation>将其旋转 %1</translation>
    </message>
    <message>
        <source>Change the tags of %1</source>
        <translation>更改 %1 的标签</translation>
    </message>
    <message>
        <source>change its tags</source>
        <translation>更改其标签</translation>
    </message>
    <message>
        <source>Change the kind of %1</source>
        <translation>更改 %1 的类型</translation>
    </message>
    <message>
        <source>change its kind</source>
        <translation>更改其类型</translation>
    </message>
    <message>
        <source>Leave %1 as it is</source>
        <translation>%1 保持不变</translation>
    </message>
</context>
<context>
    <name>WaypointFile</name>
    <message>
        <source>It is larger than 64 MiB.</source>
        <translation>它大于 64 MiB。</translation>
    </message>
    <message>
        <source>It is not UTF-8 text.</source>
        <translation>它不是 UTF-8 文本。</translation>
    </message>
</context>
<context>
    <name>WaypointJson</name>
    <message>
        <source>Its coordinates are longitude and latitude (crs %1), not metres of the map. If they are metres, remove &quot;crs&quot; from the file.</source>
        <translation>其坐标为经纬度 (crs %1)，而不是地图的米。如果确实是米，请从文件中移除“crs”。</translation>
    </message>
    <message>
        <source>Feature %1: %2</source>
        <translation>要素 %1：%2</translation>
    </message>
    <message>
        <source>It has more than %1 waypoints.</source>
        <translation>其路径点超过 %1 个。</translation>
    </message>
    <message>
        <source>Its coordinates look like longitude and latitude: as metres, all points would lie within 5 cm.</source>
        <translation>其坐标像是经纬度：若按米计，所有点都在 5 cm 以内。</translation>
    </message>
    <message>
        <source>the coordinates are not two numbers.</source>
        <translation>坐标不是两个数字。</translation>
    </message>
    <message>
        <source>Its coordinates (crs %1) were read as metres of the map.</source>
        <translation>其坐标 (crs %1) 已按地图的米读取。</translation>
    </message>
    <message>
        <source>It does not say that its coordinates are metres of the map (&quot;frame&quot;: &quot;map&quot;); they were read so.</source>
        <translation>它没有说明坐标为地图的米（&quot;frame&quot;: &quot;map&quot;）；已按此读取。</translation>
    </message>
    <message numerus="yes">
        <source>x and y of %1 features are not where their coordinates are. The coordinates count.</source>
        <translation>
            <numerusform>%1 个要素的 x 和 y 与其坐标不符。以坐标为准。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 nodes of a route graph were named by their ids.</source>
        <translation>
            <numerusform>路线图的 %1 个节点以其 id 命名。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 edges of a route graph were left out.</source>
        <translation>
            <numerusform>路线图的 %1 条边已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 features that are not points were left out.</source>
        <translation>
            <numerusform>%1 个不是点的要素已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>the id is not a text.</source>
        <translation>id 不是文本。</translation>
    </message>
    <message>
        <source>%1 is not a text.</source>
        <translation>%1 不是文本。</translation>
    </message>
    <message>
        <source>the frame is &quot;%1&quot;. Only &quot;map&quot; is supported.</source>
        <translation>坐标系为“%1”。只支持“map”。</translation>
    </message>
    <message>
        <source>x and y are not two numbers.</source>
        <translation>x 和 y 不是两个数字。</translation>
    </message>
    <message>
        <source>yaw_rad is not a number.</source>
        <translation>yaw_rad 不是数字。</translation>
    </message>
    <message>
        <source>the tags are not a list of texts.</source>
        <translation>标签不是文本列表。</translation>
    </message>
    <message>
        <source>It is not a GeoJSON FeatureCollection.</source>
        <translation>它不是 GeoJSON FeatureCollection。</translation>
    </message>
    <message>
        <source>It is not JSON (%1, byte %2).</source>
        <translation>它不是 JSON（%1，第 %2 字节）。</translation>
    </message>
    <message>
        <source>A &quot;%1&quot; is written twice. Remove one of them.</source>
        <translation>“%1”写了两次。请移除其中一个。</translation>
    </message>
</context>
<context>
    <name>WaypointPlan</name>
    <message>
        <source>Rows %1 and %2 are about the same waypoint %3. Remove one of them.</source>
        <translation>第 %1 行和第 %2 行是同一个路径点 %3。请移除其中一行。</translation>
    </message>
    <message>
        <source>Row %1: several waypoints are called &quot;%2&quot; (%3, %4). Give the id.</source>
        <translation>第 %1 行：有多个路径点叫“%2”（%3、%4）。请给出 id。</translation>
    </message>
    <message>
        <source>a waypoint %1 already exists.</source>
        <translation>路径点 %1 已存在。</translation>
    </message>
    <message>
        <source>the base of the plan has no waypoint %1.</source>
        <translation>方案的基准中没有路径点 %1。</translation>
    </message>
    <message>
        <source>%1 is already deleted.</source>
        <translation>%1 已被删除。</translation>
    </message>
    <message>
        <source>it does not say what to change about %1.</source>
        <translation>它没有说明要更改 %1 的什么。</translation>
    </message>
    <message>
        <source>A waypoint must have a name.</source>
        <translation>路径点必须有名称。</translation>
    </message>
    <message>
        <source>The name of a waypoint must be one line without control characters.</source>
        <translation>路径点名称必须是一行，且不含控制字符。</translation>
    </message>
    <message>
        <source>A tag must be one line without control characters, and not empty.</source>
        <translation>标签必须是一行，不含控制字符，且不为空。</translation>
    </message>
    <message>
        <source>A tag appears twice.</source>
        <translation>有标签出现了两次。</translation>
    </message>
    <message>
        <source>Its position is more than %1 m from the origin.</source>
        <translation>其位置距原点超过 %1 m。</translation>
    </message>
    <message>
        <source>Waypoints of this robot cannot be deleted from here.</source>
        <translation>无法从这里删除该机器人的路径点。</translation>
    </message>
    <message numerus="yes">
        <source>Waypoint types cannot be stored here: those of %1 waypoints are left out.</source>
        <translation>
            <numerusform>这里无法存储路径点类型：%1 个路径点的类型已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Tags cannot be stored here: those of %1 waypoints are left out.</source>
        <translation>
            <numerusform>这里无法存储标签：%1 个路径点的标签已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Every waypoint needs a heading here: %1 waypoints without one get 0°.</source>
        <translation>
            <numerusform>这里每个路径点都需要朝向：%1 个没有朝向的路径点设为 0°。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints cannot be deleted here: %1 waypoints that should go stay.</source>
        <translation>
            <numerusform>这里无法删除路径点：%1 个应删除的路径点会保留。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints are kept on pixels of %2 m here: %1 waypoints stay where they are, less than half a pixel from where they should be.</source>
        <translation>
            <numerusform>这里的路径点按 %2 m 的像素存储：%1 个路径点留在原处，与应在的位置相差不到半个像素。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints are not sent: the robot does not allow duplicate names</source>
        <translation>
            <numerusform>%1 个路径点不下发：机器人不允许名称重复</numerusform>
        </translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>the frame is &quot;%1&quot;. Only &quot;map&quot; is supported.</source>
        <translation>坐标系为“%1”。只支持“map”。</translation>
    </message>
    <message>
        <source>A new waypoint needs a position (x and y).</source>
        <translation>新路径点需要位置（x 和 y）。</translation>
    </message>
    <message>
        <source>The waypoint %1 appears twice. Remove one of them.</source>
        <translation>路径点 %1 出现了两次。请移除其中一个。</translation>
    </message>
    <message>
        <source>It is not JSON (%1, byte %2).</source>
        <translation>它不是 JSON（%1，第 %2 字节）。</translation>
    </message>
    <message>
        <source>It is not a plan written by mapwright waypoints plan -o.</source>
        <translation>它不是 mapwright waypoints plan -o 写出的方案。</translation>
    </message>
    <message>
        <source>The plan was made by another version of this program. Make a new plan.</source>
        <translation>该方案由此程序的另一版本制作。请重新制作方案。</translation>
    </message>
    <message>
        <source>Waypoint %1 in the base of the plan cannot be read. Make a new plan.</source>
        <translation>无法读取方案基准中的路径点 %1。请重新制作方案。</translation>
    </message>
    <message>
        <source>Change %1: %2</source>
        <translation>更改 %1：%2</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1（%2）。</translation>
    </message>
</context>
<context>
    <name>WaypointPoses</name>
    <message>
        <source>No waypoints were found in it. Known are lists of poses: {name, x, y, yaw}, {name, pose: {position, orientation}}, [x, y, yaw], also by name.</source>
        <translation>其中没有找到路径点。支持的是位姿列表：{name, x, y, yaw}、{name, pose: {position, orientation}}、[x, y, yaw]，也可按名称组织。</translation>
    </message>
    <message>
        <source>It is a map.yaml, not a list of waypoints.</source>
        <translation>它是 map.yaml，不是路径点列表。</translation>
    </message>
    <message>
        <source>It is a building map of Open-RMF: its vertices are pixels of a drawing, not metres of a map. Build its navigation graph and import that.</source>
        <translation>它是 Open-RMF 的建筑地图：其顶点是图纸的像素，而不是地图的米。请构建其导航图并导入导航图。</translation>
    </message>
    <message>
        <source>It has more than %1 waypoints.</source>
        <translation>其路径点超过 %1 个。</translation>
    </message>
    <message>
        <source>Waypoint %1: %2</source>
        <translation>路径点 %1：%2</translation>
    </message>
    <message>
        <source>The frame is &quot;%1&quot;. Only &quot;map&quot; is supported.</source>
        <translation>坐标系为“%1”。只支持“map”。</translation>
    </message>
    <message>
        <source>%1 is one flat list of numbers. A list of lists is needed: [[x, y, yaw], …].</source>
        <translation>%1 是单层的数字列表。需要列表的列表：[[x, y, yaw], …]。</translation>
    </message>
    <message>
        <source>It holds several levels of a building, but a map is one. Leave one level in it.</source>
        <translation>其中包含建筑的多个楼层，而一张地图只能是一层。请只保留一层。</translation>
    </message>
    <message numerus="yes">
        <source>%1 lanes were left out.</source>
        <translation>
            <numerusform>%1 条通道已略去。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WaypointReading</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 以及另外 %2 项</translation>
    </message>
    <message>
        <source>the list is no pose. Known are [x, y], [x, y, yaw], [x, y, z, roll, pitch, yaw] and [x, y, z, qx, qy, qz, qw].</source>
        <translation>该列表不是位姿。支持 [x, y]、[x, y, yaw]、[x, y, z, roll, pitch, yaw] 和 [x, y, z, qx, qy, qz, qw]。</translation>
    </message>
    <message>
        <source>%1 is not a text.</source>
        <translation>%1 不是文本。</translation>
    </message>
    <message>
        <source>the frame is &quot;%1&quot;. Only &quot;map&quot; is supported.</source>
        <translation>坐标系为“%1”。只支持“map”。</translation>
    </message>
    <message>
        <source>the id is not a text.</source>
        <translation>id 不是文本。</translation>
    </message>
    <message>
        <source>the tags are not a list of texts.</source>
        <translation>标签不是文本列表。</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not a number such as 1.5.</source>
        <translation>%1“%2”不是 1.5 这样的数字。</translation>
    </message>
    <message>
        <source>%1 is not a list of two or three numbers.</source>
        <translation>%1 不是两个或三个数字的列表。</translation>
    </message>
    <message>
        <source>%1 is no orientation: neither four numbers nor three.</source>
        <translation>%1 不是方向：既不是四个数字，也不是三个。</translation>
    </message>
    <message>
        <source>x &quot;%1&quot; and y &quot;%2&quot; are not two numbers such as 1.5.</source>
        <translation>x“%1”和 y“%2”不是 1.5 这样的两个数字。</translation>
    </message>
    <message>
        <source>its place is in longitude and latitude (%1), not in metres of the map.</source>
        <translation>其位置为经纬度（%1），而不是地图的米。</translation>
    </message>
    <message>
        <source>it is neither fields nor a list.</source>
        <translation>它既不是字段，也不是列表。</translation>
    </message>
    <message>
        <source>Lists of three numbers were read as x, y and heading.</source>
        <translation>三个数字的列表已按 x、y 和朝向读取。</translation>
    </message>
    <message>
        <source>Orientations that are lists were read in the order %1.</source>
        <translation>以列表表示的方向已按 %1 的顺序读取。</translation>
    </message>
    <message>
        <source>The unit of the headings (%1) is not given. They were read as degrees: %2 is too much for radians.</source>
        <translation>未给出朝向的单位（%1）。已按度读取：%2 作为弧度太大。</translation>
    </message>
    <message>
        <source>The unit of the headings (%1) is not given. They were read as radians: none is more than a full turn.</source>
        <translation>未给出朝向的单位（%1）。已按弧度读取：没有超过一整圈的。</translation>
    </message>
    <message numerus="yes">
        <source>%1 headings in radians are more than a full turn. Are they degrees?</source>
        <translation>
            <numerusform>%1 个以弧度表示的朝向超过一整圈。它们是度吗？</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 orientations are no rotation (all zero) and were left out.</source>
        <translation>
            <numerusform>%1 个方向不是旋转（全为零），已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints are tilted; only their heading was read.</source>
        <translation>
            <numerusform>%1 个路径点是倾斜的；只读取了其朝向。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The heights (z) of %1 waypoints were left out.</source>
        <translation>
            <numerusform>%1 个路径点的高度 (z) 已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out, as waypoints have no place for it: %1.</source>
        <translation>因路径点没有对应的字段而略去：%1。</translation>
    </message>
</context>
<context>
    <name>WaypointSteps</name>
    <message>
        <source>you delete it, but it was changed on the robot</source>
        <translation>您要删除它，但它在机器人上被修改过</translation>
    </message>
    <message>
        <source>you change it, but it was deleted on the robot</source>
        <translation>您要更改它，但它在机器人上已被删除</translation>
    </message>
    <message>
        <source>it was changed on the robot, too (%1)</source>
        <translation>它在机器人上也被修改过（%1）</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m</source>
        <translation>x %1 m，y %2 m</translation>
    </message>
    <message>
        <source>, %1°</source>
        <translation>，%1°</translation>
    </message>
    <message>
        <source>Whether it was changed is unknown.</source>
        <translation>是否已更改未知。</translation>
    </message>
    <message>
        <source>The robot accepted the change, but it has no effect.</source>
        <translation>机器人接受了更改，但没有生效。</translation>
    </message>
</context>
<context>
    <name>WaypointTable</name>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>there is a quote in the middle of a field. Quote the whole field and double the quotes inside it.</source>
        <translation>字段中间有引号。请将整个字段加上引号，并将其中的引号写成两个。</translation>
    </message>
    <message>
        <source>a quote is missing at the end of a field.</source>
        <translation>字段末尾缺少引号。</translation>
    </message>
    <message>
        <source>there is text after a closing quote.</source>
        <translation>右引号之后还有文本。</translation>
    </message>
    <message>
        <source>the column &quot;%1&quot; appears twice.</source>
        <translation>列“%1”出现了两次。</translation>
    </message>
    <message>
        <source>only one of the columns x and y is present.</source>
        <translation>只有 x 和 y 中的一列。</translation>
    </message>
    <message>
        <source>there is neither a place (x, y) nor an id or a name. The header is %1.</source>
        <translation>既没有位置 (x, y)，也没有 id 或名称。表头为 %1。</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>the tags are not a list: %1</source>
        <translation>标签不是列表：%1</translation>
    </message>
    <message>
        <source>the tags contain a line break.</source>
        <translation>标签中含有换行。</translation>
    </message>
    <message>
        <source>It is larger than 64 MiB.</source>
        <translation>它大于 64 MiB。</translation>
    </message>
    <message>
        <source>It is not UTF-8 text.</source>
        <translation>它不是 UTF-8 文本。</translation>
    </message>
    <message>
        <source>It is empty.</source>
        <translation>它是空的。</translation>
    </message>
    <message>
        <source>It has more than %1 waypoints.</source>
        <translation>其路径点超过 %1 个。</translation>
    </message>
    <message>
        <source>it has %1 fields, but the header has %2.</source>
        <translation>它有 %1 个字段，但表头有 %2 个。</translation>
    </message>
    <message>
        <source>It has too many columns for a waypoint list.</source>
        <translation>其列数对路径点列表来说太多。</translation>
    </message>
    <message numerus="yes">
        <source>%1 comment lines (#) were left out.</source>
        <translation>
            <numerusform>%1 行注释 (#) 已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>Commas in numbers were read as decimal points.</source>
        <translation>数字中的逗号已按小数点读取。</translation>
    </message>
    <message>
        <source>It needs two adjacent columns of numbers: x and y in metres. Or start with a row that names the columns: name, x, y, heading, tags.</source>
        <translation>它需要两个相邻的数字列：x 和 y，单位为米。或者以一行列名开头：name, x, y, heading, tags。</translation>
    </message>
    <message>
        <source>It has no column names. Its columns were read as %1.</source>
        <translation>它没有列名。其各列已按 %1 读取。</translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints without a name were numbered.</source>
        <translation>
            <numerusform>%1 个没有名称的路径点已编号。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>agreement</name>
    <message>
        <source>The submaps cover more than the %1 squares of %2 m that can be looked at. Larger cells need fewer squares.</source>
        <translation>子图覆盖的范围超过可查看的 %1 个 %2 m 方格。栅格越大，需要的方格越少。</translation>
    </message>
</context>
<context>
    <name>aimdk</name>
    <message>
        <source>The list cannot be loaded: the robot refused.</source>
        <translation>无法加载列表：机器人拒绝了。</translation>
    </message>
    <message>
        <source>The list cannot be loaded: the robot answered %1.</source>
        <translation>无法加载列表：机器人应答 %1。</translation>
    </message>
    <message>
        <source>The list cannot be loaded: the robot refused (code %1).</source>
        <translation>无法加载列表：机器人拒绝了（代码 %1）。</translation>
    </message>
    <message>
        <source>Its firmware does not support this request (%1).</source>
        <translation>其固件不支持该请求（%1）。</translation>
    </message>
    <message>
        <source>a web server answers there, but it is no Agibot robot</source>
        <translation>那里应答的是 Web 服务器，但不是 Agibot 机器人</translation>
    </message>
    <message>
        <source>The robot&apos;s answer is not JSON, so it may not be an %1 robot.</source>
        <translation>机器人的应答不是 JSON，因此它可能不是 %1 机器人。</translation>
    </message>
    <message>
        <source>Point %1 (%2): its pixel and metre coordinates differ by %3 px. It is shown at its metre coordinates.</source>
        <translation>点 %1（%2）：其像素坐标与米坐标相差 %3 px。按米坐标显示。</translation>
    </message>
    <message>
        <source>Its resolution %1 was read as centimetres per pixel: only so do the pixels of its points fit their metres.</source>
        <translation>其分辨率 %1 已按每像素厘米数读取：只有这样，其点的像素才与米相符。</translation>
    </message>
    <message>
        <source>Whether its resolution %1 means pixels per metre or centimetres per pixel cannot be seen from its points. It was read as pixels per metre, as its maker says.</source>
        <translation>根据其点无法判断分辨率 %1 表示每米像素数还是每像素厘米数。已按厂商的说明，作为每米像素数读取。</translation>
    </message>
    <message>
        <source>The pixels of its points fit their metres neither if its resolution %1 means pixels per metre nor if it means centimetres per pixel: its picture may lie elsewhere. It was read as pixels per metre.</source>
        <translation>无论分辨率 %1 表示每米像素数还是每像素厘米数，其点的像素都与米不符：其图像可能在别处。已按厂商的说明，作为每米像素数读取。</translation>
    </message>
    <message numerus="yes">
        <source>%1 more points have pixel and metre coordinates that differ.</source>
        <translation>
            <numerusform>另有 %1 个点的像素坐标与米坐标不同。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 points have no metre coordinates. They are shown at their pixel coordinates.</source>
        <translation>
            <numerusform>%1 个点没有米坐标。按其像素坐标显示。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 paths of this map are not shown.</source>
        <translation>
            <numerusform>该地图的 %1 条路径未显示。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 regions of this map are not shown.</source>
        <translation>
            <numerusform>该地图的 %1 个区域未显示。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 maps in the robot&apos;s list have no id. They were left out.</source>
        <translation>
            <numerusform>机器人列表中有 %1 张地图没有 id，已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>The robot is not mapping.</source>
        <translation>机器人没有在建图。</translation>
    </message>
    <message>
        <source>The pixels of %1 are not where its metres are: the robot might move it when it is renamed. Move it first.</source>
        <translation>%1 的像素与其米坐标不在同一处：重命名时机器人可能会移动它。请先移动它。</translation>
    </message>
    <message>
        <source>The robot takes pixels, and the waypoints of this map do not show where its pixels lie: a new one might land in the wrong place. Set some waypoints on the robot itself first, apart from each other.</source>
        <translation>机器人使用像素，而该地图的路径点无法说明其像素的位置：新路径点可能落在错误的地方。请先在机器人上设置几个彼此分开的路径点。</translation>
    </message>
    <message>
        <source>Waypoints of this robot cannot be deleted from here.</source>
        <translation>无法从这里删除该机器人的路径点。</translation>
    </message>
    <message>
        <source>Waypoints of this robot cannot have tags.</source>
        <translation>该机器人的路径点不能有标签。</translation>
    </message>
    <message>
        <source>The robot accepted the waypoint &quot;%1&quot;, but does not list it.</source>
        <translation>机器人接受了路径点“%1”，但没有列出它。</translation>
    </message>
    <message>
        <source>The robot accepted the change of &quot;%1&quot;, but lists the waypoint otherwise.</source>
        <translation>机器人接受了对“%1”的更改，但列出的路径点不同。</translation>
    </message>
    <message>
        <source>The robot accepted the waypoint &quot;%1&quot;, but lists it %2 m from where it should be.</source>
        <translation>机器人接受了路径点“%1”，但列出的位置与应在的位置相差 %2 m。</translation>
    </message>
    <message>
        <source>The rosbridge that provides the robot&apos;s pose cannot be reached at %1: %2. Maps and waypoints work without it.</source>
        <translation>无法连接提供机器人位姿的 rosbridge %1：%2。没有它，地图和路径点仍可使用。</translation>
    </message>
    <message>
        <source>a web server answers there, but it does not know the requests of Agibot robots (%1): check the address and the port</source>
        <translation>那里应答的是 Web 服务器，但它不认识 Agibot 机器人的请求（%1）：请检查地址和端口</translation>
    </message>
    <message>
        <source>the answer contains no data</source>
        <translation>应答中没有数据</translation>
    </message>
    <message>
        <source>The robot&apos;s list of maps is not a list.</source>
        <translation>机器人的地图列表不是列表。</translation>
    </message>
    <message>
        <source>Its resolution is missing or not above 0 pixels per metre, so its position is unknown.</source>
        <translation>其分辨率缺失，或不大于每米 0 像素，因此其位置未知。</translation>
    </message>
    <message>
        <source>The robot sent the map %1 instead.</source>
        <translation>机器人发送的却是地图 %1。</translation>
    </message>
    <message>
        <source>The robot sent no picture for it.</source>
        <translation>机器人没有发送它的图像。</translation>
    </message>
    <message>
        <source>Its picture is not valid base64, or larger than 256 MB.</source>
        <translation>其图像不是有效的 base64，或大于 256 MB。</translation>
    </message>
    <message>
        <source>Its picture has %1 x %2 cells, but the robot says %3 x %4. The size of the picture was used.</source>
        <translation>其图像为 %1 x %2 栅格，而机器人称为 %3 x %4。已采用图像的大小。</translation>
    </message>
    <message>
        <source>Its picture is not a PNG, and the robot does not say how high it is.</source>
        <translation>其图像不是 PNG，且机器人没有说明图像的高度。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed on the robot in the meantime</source>
        <translation>“%1”在此期间在机器人上被修改过</translation>
    </message>
</context>
<context>
    <name>axbot</name>
    <message>
        <source>The robot&apos;s answers cannot be saved to disk</source>
        <translation>机器人的应答无法保存到磁盘</translation>
    </message>
    <message>
        <source>The robot has not sent a list yet. It may have no SLAM session, or its firmware may not have the topic %1. Still listening.</source>
        <translation>机器人尚未发送列表。它可能没有 SLAM 会话，或其固件可能没有话题 %1。仍在监听。</translation>
    </message>
    <message>
        <source>It does not report what it is</source>
        <translation>它没有上报自己是什么</translation>
    </message>
    <message>
        <source>a web server answers there, but it is no Autoxing robot</source>
        <translation>那里应答的是 Web 服务器，但不是 Autoxing 机器人</translation>
    </message>
    <message>
        <source>a web server answers there, but not as an Autoxing robot does: %1</source>
        <translation>那里应答的是 Web 服务器，但应答方式与 Autoxing 机器人不同：%1</translation>
    </message>
    <message>
        <source>The robot accepted the recording, but does not list it.</source>
        <translation>机器人接受了录制请求，但没有列出该录制文件。</translation>
    </message>
    <message>
        <source>Row %1 has no valid trajectory_id or submap_index and was left out.</source>
        <translation>第 %1 行没有有效的 trajectory_id 或 submap_index，已略去。</translation>
    </message>
    <message numerus="yes">
        <source>None of its %1 rows has a valid trajectory_id and submap_index. The previous list stays.</source>
        <translation>
            <numerusform>其 %1 行都没有有效的 trajectory_id 和 submap_index。保留之前的列表。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The robot&apos;s answer (%1 bytes) is cut off or is not a submap.</source>
        <translation>
            <numerusform>机器人的应答（%1 字节）被截断，或不是子图。</numerusform>
        </translation>
    </message>
    <message>
        <source>The robot answered %1</source>
        <translation>机器人应答 %1</translation>
    </message>
    <message>
        <source>Shown without %1</source>
        <translation>显示时不包含 %1</translation>
    </message>
    <message>
        <source>its answer is not a list</source>
        <translation>其应答不是列表</translation>
    </message>
    <message numerus="yes">
        <source>A message of %1 bytes is not a JSON object. It was left out.</source>
        <translation>
            <numerusform>一条 %1 字节的消息不是 JSON 对象，已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A binary message of %1 bytes is too short to be read. It was left out.</source>
        <translation>
            <numerusform>一条 %1 字节的二进制消息太短，无法读取，已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>Its &quot;%1&quot; member is not a list.</source>
        <translation>其成员“%1”不是列表。</translation>
    </message>
    <message>
        <source>Its coordinates are missing, too few, or not numbers.</source>
        <translation>其坐标缺失、太少或不是数字。</translation>
    </message>
    <message>
        <source>The address of its picture is not valid.</source>
        <translation>其图像的地址无效。</translation>
    </message>
    <message>
        <source>Its picture %1 cannot be loaded</source>
        <translation>无法加载其图像 %1</translation>
    </message>
    <message>
        <source>the answer is empty</source>
        <translation>应答是空的</translation>
    </message>
    <message>
        <source>%1 is not a time range</source>
        <translation>%1 不是时间范围</translation>
    </message>
    <message>
        <source>%1 bytes arrived, but the robot says that it has %2</source>
        <translation>到达了 %1 字节，但机器人称有 %2</translation>
    </message>
    <message>
        <source>there is a server at %1, but not an Autoxing robot: %2. Check the address and the port.</source>
        <translation>%1 处有服务器，但不是 Autoxing 机器人：%2。请检查地址和端口。</translation>
    </message>
    <message>
        <source>The robot&apos;s answer contains no pose that can be read.</source>
        <translation>机器人的应答中没有可读取的位姿。</translation>
    </message>
    <message>
        <source>it was changed on the robot in the meantime; start the download again</source>
        <translation>它在此期间在机器人上被更改过；请重新开始下载</translation>
    </message>
    <message>
        <source>The robot accepted the deletion, but still has it.</source>
        <translation>机器人接受了删除，但仍保留着它。</translation>
    </message>
    <message>
        <source>The robot ended mapping, but kept what was mapped: it lists it as finished.</source>
        <translation>机器人结束了建图，但保留了建图结果：它将其列为已完成。</translation>
    </message>
    <message>
        <source>The robot ended mapping, but lists it as cancelled.</source>
        <translation>机器人结束了建图，但将其列为已取消。</translation>
    </message>
    <message>
        <source>There is no finished mapping that could be saved.</source>
        <translation>没有可保存的已完成建图。</translation>
    </message>
    <message>
        <source>the answer contains no list of messages</source>
        <translation>应答中没有消息列表</translation>
    </message>
    <message>
        <source>the answer does not contain its start and end time</source>
        <translation>应答中没有其开始和结束时间</translation>
    </message>
    <message>
        <source>Its points are not valid base64, or too many.</source>
        <translation>其点不是有效的 base64，或太多。</translation>
    </message>
    <message>
        <source>It contains no readable points.</source>
        <translation>其中没有可读取的点。</translation>
    </message>
    <message>
        <source>Its points have no valid scale or centre.</source>
        <translation>其点没有有效的比例或中心。</translation>
    </message>
    <message>
        <source>Its geometry &quot;%1&quot; is not known.</source>
        <translation>其几何类型“%1”未知。</translation>
    </message>
    <message>
        <source>The robot&apos;s answer is not a map picture, or is cut off.</source>
        <translation>机器人的应答不是地图图像，或被截断。</translation>
    </message>
    <message>
        <source>The robot sent no picture.</source>
        <translation>机器人没有发送图像。</translation>
    </message>
    <message>
        <source>The robot sent an empty answer.</source>
        <translation>机器人发送了空的应答。</translation>
    </message>
    <message>
        <source>It lists submaps, but not the uuid of their SLAM session, so none can be loaded. The previous list stays.</source>
        <translation>它列出了子图，但没有其 SLAM 会话的 uuid，因此都无法加载。保留之前的列表。</translation>
    </message>
    <message>
        <source>The picture in the message is not valid base64, or too large.</source>
        <translation>消息中的图像不是有效的 base64，或太大。</translation>
    </message>
    <message>
        <source>It contains neither a picture nor the address of one.</source>
        <translation>其中既没有图像，也没有图像的地址。</translation>
    </message>
    <message>
        <source>A compressed message could not be unpacked. The previous data stays.</source>
        <translation>有一条压缩消息无法解压。保留之前的数据。</translation>
    </message>
    <message>
        <source>A binary message contains no readable points.</source>
        <translation>有一条二进制消息没有可读取的点。</translation>
    </message>
    <message>
        <source>A binary message could not be read. The previous list stays.</source>
        <translation>有一条二进制消息无法读取。保留之前的列表。</translation>
    </message>
    <message>
        <source>the robot accepted the pose, but does not say where it is</source>
        <translation>机器人接受了位姿，但没有报告自己在哪里</translation>
    </message>
    <message>
        <source>The robot accepted the pose, but says that it is still where it was before.</source>
        <translation>机器人接受了位姿，但报告自己仍在原来的位置。</translation>
    </message>
    <message>
        <source>the robot accepted it, but does not say what came of it</source>
        <translation>机器人接受了，但没有报告结果</translation>
    </message>
    <message>
        <source>The robot sees no charger here.</source>
        <translation>机器人在这里没有看到充电桩。</translation>
    </message>
    <message>
        <source>The robot sees no rack here.</source>
        <translation>机器人在这里没有看到货架。</translation>
    </message>
    <message>
        <source>The robot sees no pallet here.</source>
        <translation>机器人在这里没有看到托盘。</translation>
    </message>
    <message>
        <source>The robot sees no trailer here.</source>
        <translation>机器人在这里没有看到拖车。</translation>
    </message>
    <message>
        <source>It contains no list of submaps. The previous list stays.</source>
        <translation>其中没有子图列表。保留之前的列表。</translation>
    </message>
    <message>
        <source>The robot&apos;s pose contains no valid numbers.</source>
        <translation>机器人的位姿不含有效数字。</translation>
    </message>
    <message>
        <source>the robot already has this map: %2 (id %1)</source>
        <translation>机器人已有该地图：%2 (id %1)</translation>
    </message>
    <message>
        <source>and %1 bytes more</source>
        <translation>还有 %1 字节</translation>
    </message>
</context>
<context>
    <name>cells</name>
    <message>
        <source>cell format %1 is unknown: with one byte per cell only 0, 1 and 2 are supported</source>
        <translation>栅格格式 %1 未知：每栅格一个字节时只支持 0、1 和 2</translation>
    </message>
    <message>
        <source>more than %1 bytes where %2 (or %3) were expected</source>
        <translation>应为 %2（或 %3）字节，实际超过 %1 字节</translation>
    </message>
    <message>
        <source>the zlib data is damaged or cut off</source>
        <translation>zlib 数据已损坏或被截断</translation>
    </message>
    <message>
        <source>the PNG cannot be read (%1)</source>
        <translation>无法读取 PNG（%1）</translation>
    </message>
    <message>
        <source>the PNG header is cut off</source>
        <translation>PNG 头被截断</translation>
    </message>
    <message>
        <source>there is not enough memory to read the PNG</source>
        <translation>内存不足，无法读取 PNG</translation>
    </message>
    <message>
        <source>the PNG cannot be read</source>
        <translation>无法读取 PNG</translation>
    </message>
    <message>
        <source>the PNG is %1 but should be %2</source>
        <translation>PNG 为 %1，但应为 %2</translation>
    </message>
    <message>
        <source>the PNG is cut off: %1 bytes are too few for %2 pixels</source>
        <translation>PNG 被截断：%1 字节对 %2 像素来说太少</translation>
    </message>
    <message>
        <source>the texture claims to have %1 cells</source>
        <translation>纹理声明有 %1 个栅格</translation>
    </message>
    <message>
        <source>the texture claims to have %1 cells; at most %2 are allowed</source>
        <translation>纹理声明有 %1 个栅格；最多允许 %2 个</translation>
    </message>
    <message>
        <source>the cell size is not a positive number of metres</source>
        <translation>栅格大小不是正的米数</translation>
    </message>
    <message>
        <source>the cell size is less than 0.1 mm</source>
        <translation>栅格大小小于 0.1 mm</translation>
    </message>
    <message>
        <source>the cell size is more than 100 m</source>
        <translation>栅格大小大于 100 m</translation>
    </message>
    <message numerus="yes">
        <source>%1 bytes where %2 (or %3) were expected</source>
        <translation>
            <numerusform>应为 %2（或 %3）字节，实际为 %1 字节</numerusform>
        </translation>
    </message>
    <message>
        <source>the gzip data is damaged or cut off</source>
        <translation>gzip 数据已损坏或被截断</translation>
    </message>
</context>
<context>
    <name>compare</name>
    <message>
        <source>%1: the picture of the differences cannot be encoded.</source>
        <translation>%1：无法编码差异图像。</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>无法读取 %1</translation>
    </message>
    <message>
        <source>it has %1 pixels, but at most %2 can be compared</source>
        <translation>它有 %1 像素，但最多只能比较 %2</translation>
    </message>
    <message>
        <source>it is %2 pixels, but only %1 rows of it can be read</source>
        <translation>它为 %2 像素，但只能读取其中 %1 行</translation>
    </message>
    <message>
        <source>The mask %1 is %2 pixels, but the expected picture is %3.</source>
        <translation>遮罩 %1 为 %2 像素，而期望图像为 %3。</translation>
    </message>
    <message>
        <source>it is an animation, and only single pictures can be compared</source>
        <translation>它是动画，只能比较单张图片</translation>
    </message>
</context>
<context>
    <name>disk</name>
    <message>
        <source>%1 cannot be written</source>
        <translation>无法写入 %1</translation>
    </message>
    <message>
        <source>it is a directory</source>
        <translation>它是目录</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>它不是普通文件</translation>
    </message>
    <message>
        <source>it is a pointer of Git LFS, not the file itself (git lfs pull fetches it)</source>
        <translation>它是 Git LFS 指针，而不是文件本身（可用 git lfs pull 获取）</translation>
    </message>
    <message>
        <source>a file of that name is there already; the result is in %1</source>
        <translation>已有同名文件；结果在 %1 中</translation>
    </message>
    <message>
        <source>no file can be created in %1 (%2)</source>
        <translation>无法在 %1 中创建文件（%2）</translation>
    </message>
    <message>
        <source>The standard output cannot be written</source>
        <translation>无法写入标准输出</translation>
    </message>
    <message>
        <source>it is a block device, not a file</source>
        <translation>它是块设备，不是文件</translation>
    </message>
    <message>
        <source>it is a socket, not a file</source>
        <translation>它是套接字，不是文件</translation>
    </message>
    <message>
        <source>nothing reads from this pipe</source>
        <translation>没有程序从该管道读取</translation>
    </message>
    <message>
        <source>the program that reads from it is blocked</source>
        <translation>从它读取的程序被阻塞</translation>
    </message>
</context>
<context>
    <name>edit</name>
    <message>
        <source>The draft %1 cannot be removed.</source>
        <translation>无法移除草稿 %1。</translation>
    </message>
    <message>
        <source>Drafts cannot be saved: no file can be created in %1. Is the disk full?</source>
        <translation>无法保存草稿：无法在 %1 中创建文件。磁盘是否已满？</translation>
    </message>
    <message>
        <source>The draft %1 cannot be read</source>
        <translation>无法读取草稿 %1</translation>
    </message>
    <message>
        <source>The draft %1 is not in a known format.</source>
        <translation>草稿 %1 的格式未知。</translation>
    </message>
    <message>
        <source>The draft %1 is not in a known format. It was renamed to %2.</source>
        <translation>草稿 %1 的格式未知。它已重命名为 %2。</translation>
    </message>
    <message>
        <source>Drafts cannot be saved: the folder %1 cannot be created.</source>
        <translation>无法保存草稿：无法创建文件夹 %1。</translation>
    </message>
    <message>
        <source>The saved waypoint draft has disappeared. The waypoints are still open here: saving writes them again.</source>
        <translation>已保存的路径点草稿不见了。路径点在这里仍然打开：保存会重新写入。</translation>
    </message>
</context>
<context>
    <name>fault</name>
    <message>
        <source>the answer is longer than the %1 bytes allowed</source>
        <translation>应答超过允许的 %1 字节</translation>
    </message>
</context>
<context>
    <name>files</name>
    <message>
        <source>There is no file %1.</source>
        <translation>没有文件 %1。</translation>
    </message>
    <message>
        <source>Its picture cannot be read.</source>
        <translation>无法读取其图像。</translation>
    </message>
    <message>
        <source>Several map.yaml files name this picture, so none is used: %1. Open the right one.</source>
        <translation>多个 map.yaml 文件都指定了该图像，因此都未采用：%1。请打开正确的那个。</translation>
    </message>
    <message>
        <source>It is not YAML (line %1).</source>
        <translation>它不是 YAML（第 %1 行）。</translation>
    </message>
    <message>
        <source>Its origin has %1 numbers. It must have three: x, y and yaw.</source>
        <translation>其 origin 有 %1 个数字。必须有三个：x、y 和 yaw。</translation>
    </message>
    <message>
        <source>There is no such map.</source>
        <translation>没有这张地图。</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>无法读取 %1</translation>
    </message>
    <message>
        <source>%1 has changed on disk in the meantime.</source>
        <translation>%1 在此期间在磁盘上被更改过。</translation>
    </message>
    <message>
        <source>it is larger than %1</source>
        <translation>它大于 %1</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>它是空的</translation>
    </message>
    <message>
        <source>it is not a GeoJSON FeatureCollection</source>
        <translation>它不是 GeoJSON FeatureCollection</translation>
    </message>
    <message>
        <source>Headings in &quot;%1&quot; are not shown: a map&apos;s own list has them in yaw_rad. Importing the file reads them.</source>
        <translation>“%1”中的朝向未显示：地图自身的列表用 yaw_rad 表示朝向。导入该文件即可读取。</translation>
    </message>
    <message>
        <source>%1 is not a file.</source>
        <translation>%1 不是文件。</translation>
    </message>
    <message>
        <source>You are not allowed to read the file %1.</source>
        <translation>您没有权限读取文件 %1。</translation>
    </message>
    <message>
        <source>Its picture is outside its folder: %1.</source>
        <translation>其图像在其文件夹之外：%1。</translation>
    </message>
    <message>
        <source>Several map.yaml files name this picture, so none is used: %1 and %2 more. Open the right one.</source>
        <translation>多个 map.yaml 文件都指定了该图像，因此都未采用：%1 以及另外 %2 个。请打开正确的那个。</translation>
    </message>
    <message>
        <source>A picture alone does not tell the size of its cells. 0.05 m is assumed; append ?resolution=0.05 to the path to change it.</source>
        <translation>单独的图像无法说明其栅格的大小。假定为 0.05 m；要更改，请在路径后加上 ?resolution=0.05。</translation>
    </message>
    <message>
        <source>%1 in the same folder does not name this picture as its image, or is not a valid map.yaml.</source>
        <translation>同一文件夹中的 %1 没有将该图像指定为其图像，或不是有效的 map.yaml。</translation>
    </message>
    <message>
        <source>There are no maps (map.yaml, PNG, PGM, BMP) in %1.</source>
        <translation>%1 中没有地图（map.yaml、PNG、PGM、BMP）。</translation>
    </message>
    <message>
        <source>It has no origin, so the position of the map is unknown. Add for example: origin: [0.0, 0.0, 0.0]</source>
        <translation>它没有 origin，因此地图的位置未知。例如添加：origin: [0.0, 0.0, 0.0]</translation>
    </message>
    <message>
        <source>Its origin is not a list of x, y and yaw.</source>
        <translation>其 origin 不是 x、y 和 yaw 的列表。</translation>
    </message>
    <message>
        <source>The yaw of its origin is not a number; 0 is used.</source>
        <translation>其 origin 的 yaw 不是数字；采用 0。</translation>
    </message>
    <message>
        <source>Its origin contains something that is not a number.</source>
        <translation>其 origin 中含有不是数字的内容。</translation>
    </message>
    <message>
        <source>Its origin has two numbers, but map_server needs three. A yaw of 0 is used.</source>
        <translation>其 origin 有两个数字，但 map_server 需要三个。采用的 yaw 为 0。</translation>
    </message>
    <message>
        <source>Its origin has %1 numbers, but map_server takes three. They were read as %2.</source>
        <translation>其 origin 有 %1 个数字，但 map_server 取三个。已按 %2 读取。</translation>
    </message>
    <message>
        <source>negate is missing, but map_server needs it; 0 is assumed.</source>
        <translation>缺少 negate，但 map_server 需要它；假定为 0。</translation>
    </message>
    <message>
        <source>Its negate is neither 0 nor 1.</source>
        <translation>其 negate 既不是 0 也不是 1。</translation>
    </message>
    <message>
        <source>%1 is missing, but map_server needs it; %2 is assumed.</source>
        <translation>缺少 %1，但 map_server 需要它；假定为 %2。</translation>
    </message>
    <message>
        <source>Its %1 is not a number from 0 to 1.</source>
        <translation>其 %1 不是 0 到 1 的数字。</translation>
    </message>
    <message>
        <source>Its mode is unknown. It must be trinary, scale or raw.</source>
        <translation>其 mode 未知。必须是 trinary、scale 或 raw。</translation>
    </message>
    <message>
        <source>It does not name an image.</source>
        <translation>它没有指定图像。</translation>
    </message>
    <message>
        <source>It has no resolution, so the position of the map is unknown. Add for example: resolution: 0.05</source>
        <translation>它没有 resolution，因此地图的位置未知。例如添加：resolution: 0.05</translation>
    </message>
    <message>
        <source>%1 is missing or no number, but map_server needs it in any mode.</source>
        <translation>%1 缺失或不是数字，但 map_server 在任何模式下都需要它。</translation>
    </message>
    <message>
        <source>Its free_thresh is not below its occupied_thresh, so no cell can be unknown.</source>
        <translation>其 free_thresh 不小于其 occupied_thresh，因此不可能有未知栅格。</translation>
    </message>
    <message>
        <source>It is too long for a map.yaml.</source>
        <translation>作为 map.yaml 太长。</translation>
    </message>
    <message>
        <source>It is not a map.yaml: image, resolution and origin are missing.</source>
        <translation>它不是 map.yaml：缺少 image、resolution 和 origin。</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>无法打开 %1</translation>
    </message>
    <message>
        <source>The yaw_rad of waypoint %1 is not a number. It is shown without a heading.</source>
        <translation>路径点 %1 的 yaw_rad 不是数字。显示时没有朝向。</translation>
    </message>
    <message>
        <source>it is not JSON (%1)</source>
        <translation>它不是 JSON（%1）</translation>
    </message>
    <message>
        <source>its coordinates are longitude and latitude (crs %1), not metres of the map. If they are metres, remove &quot;crs&quot; from it</source>
        <translation>其坐标为经纬度 (crs %1)，而不是地图的米。如果确实是米，请从中移除“crs”</translation>
    </message>
    <message>
        <source>it has more than one list of features</source>
        <translation>它有不止一个要素列表</translation>
    </message>
    <message>
        <source>it has more than %1 waypoints</source>
        <translation>其路径点超过 %1 个</translation>
    </message>
    <message>
        <source>it has two lists of features</source>
        <translation>它有两个要素列表</translation>
    </message>
    <message numerus="yes">
        <source>%1 features are not points that can be read. They are not shown.</source>
        <translation>
            <numerusform>%1 个要素不是可以读取的点，未显示。</numerusform>
        </translation>
    </message>
    <message>
        <source>The yaw of its origin is more than a full turn. It is read as radians, not degrees.</source>
        <translation>其原点的朝向超过一整圈。它按弧度而不是度读取。</translation>
    </message>
    <message>
        <source>%1 is written twice. The first one counts.</source>
        <translation>%1 写了两次，以第一个为准。</translation>
    </message>
    <message>
        <source>It holds more than one document. Only the first one is read.</source>
        <translation>它包含多个文档，只读取第一个。</translation>
    </message>
    <message>
        <source>The frame of waypoint %1 is not the map. It is shown as if it were.</source>
        <translation>路径点 %1 的坐标系不是地图，仍按地图显示。</translation>
    </message>
    <message>
        <source>The tags of waypoint %1 are not a list of texts. What is no text is not shown.</source>
        <translation>路径点 %1 的标签不是文本列表，非文本的部分未显示。</translation>
    </message>
    <message>
        <source>Its coordinates (crs %1) are read as metres of the map.</source>
        <translation>其坐标 (crs %1) 按地图的米读取。</translation>
    </message>
</context>
<context>
    <name>grids</name>
    <message>
        <source>This kind of BMP is not supported (its header has %1 bytes). Save it as PNG.</source>
        <translation>不支持这种 BMP（其文件头为 %1 字节）。请另存为 PNG。</translation>
    </message>
    <message>
        <source>It is a BMP with a negative width.</source>
        <translation>它是宽度为负的 BMP。</translation>
    </message>
    <message>
        <source>It is a BMP with %1 bits per pixel; only 1, 4, 8, 24 and 32 bits, uncompressed, are supported. Save it as PNG.</source>
        <translation>它是每像素 %1 位的 BMP；只支持未压缩的 1、4、8、24 和 32 位。请另存为 PNG。</translation>
    </message>
    <message>
        <source>It is a compressed BMP with %1 bits per pixel; only 1, 4, 8, 24 and 32 bits, uncompressed, are supported. Save it as PNG.</source>
        <translation>它是每像素 %1 位的压缩 BMP；只支持未压缩的 1、4、8、24 和 32 位。请另存为 PNG。</translation>
    </message>
    <message>
        <source>It is a BMP whose colours are not whole bytes. Save it as PNG.</source>
        <translation>它是颜色分量不为整字节的 BMP。请另存为 PNG。</translation>
    </message>
    <message>
        <source>It is a BMP whose palette is cut off.</source>
        <translation>它是调色板被截断的 BMP。</translation>
    </message>
    <message>
        <source>It is %1 pixels, but at most %2 can be read.</source>
        <translation>它为 %1 像素，但最多只能读取 %2。</translation>
    </message>
    <message>
        <source>The thresholds of a map.yaml are numbers from 0 to 1.</source>
        <translation>map.yaml 的阈值是 0 到 1 的数字。</translation>
    </message>
    <message>
        <source>Between the thresholds %1 (free) and %2 (occupied) there is no gray level for unknown cells.</source>
        <translation>在阈值 %1（空闲）和 %2（占据）之间，没有可用于未知栅格的灰度。</translation>
    </message>
    <message>
        <source>It is empty: it contains no picture.</source>
        <translation>它是空的：不含图像。</translation>
    </message>
    <message>
        <source>The file %1 cannot be opened</source>
        <translation>无法打开文件 %1</translation>
    </message>
    <message>
        <source>Its header says %1 pixels. A map may have at most %2 along an edge and %3 in total.</source>
        <translation>其文件头声明为 %1 像素。地图每边最多 %2 像素，总共最多 %3 像素。</translation>
    </message>
    <message numerus="yes">
        <source>Its header says %2 pixels, but %3 after %1 rows. The rest is shown as unknown.</source>
        <translation>
            <numerusform>其文件头声明为 %2 像素，但 %1 行之后%3。其余部分显示为未知。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Its header says %2 pixels, but %3 after %1 rows.</source>
        <translation>
            <numerusform>其文件头声明为 %2 像素，但 %1 行之后%3。</numerusform>
        </translation>
    </message>
    <message>
        <source>its data ends</source>
        <translation>其数据结束</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>其数据已损坏</translation>
    </message>
    <message>
        <source>the checksum of its pixels is wrong</source>
        <translation>其像素的校验和错误</translation>
    </message>
    <message>
        <source>It is a BMP whose header is cut off.</source>
        <translation>它是文件头被截断的 BMP。</translation>
    </message>
    <message>
        <source>It is a PNG whose header is cut off.</source>
        <translation>它是文件头被截断的 PNG。</translation>
    </message>
    <message>
        <source>It is a PNG that is cut off before the first pixel.</source>
        <translation>它是在第一个像素之前就被截断的 PNG。</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>已取消；未写入任何内容。</translation>
    </message>
    <message>
        <source>The PNG %1 cannot be written: the encoder failed.</source>
        <translation>无法写入 PNG %1：编码器失败。</translation>
    </message>
    <message>
        <source>The size of the picture %1 has changed.</source>
        <translation>图像 %1 的大小变了。</translation>
    </message>
    <message numerus="yes">
        <source>%1 cells are outside the range of -1 to 100. They are shown as unknown.</source>
        <translation>
            <numerusform>%1 个栅格超出 -1 到 100 的范围。显示为未知。</numerusform>
        </translation>
    </message>
    <message>
        <source>it has %1 cells, too many for a preview in a list</source>
        <translation>它有 %1 个栅格，对列表中的预览来说太多</translation>
    </message>
    <message>
        <source>The cached copy is damaged and the picture can no longer be read: parts of it are missing. Open it again.</source>
        <translation>缓存的副本已损坏，且图像已无法读取：有部分缺失。请重新打开。</translation>
    </message>
    <message>
        <source>It is %1 pixels and all rows are present, but %2. Some of it may be wrong.</source>
        <translation>它为 %1 像素且各行齐全，但%2。其中部分内容可能有误。</translation>
    </message>
    <message>
        <source>a number exceeds the maximum in the header</source>
        <translation>有数字超过文件头中的最大值</translation>
    </message>
    <message>
        <source>something in it is not a number</source>
        <translation>其中含有不是数字的内容</translation>
    </message>
    <message>
        <source>It is a PGM whose header is cut off or invalid.</source>
        <translation>它是文件头被截断或无效的 PGM。</translation>
    </message>
    <message>
        <source>It is a PGM with a maximum gray of %1; it must be 1 to 65535.</source>
        <translation>它是最大灰度为 %1 的 PGM；必须为 1 到 65535。</translation>
    </message>
    <message>
        <source>Its header says %1 pixels: it is empty.</source>
        <translation>其文件头声明为 %1 像素：它是空的。</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>无法读取。</translation>
    </message>
    <message>
        <source>It is a pointer of Git LFS, not the picture itself (git lfs pull fetches it).</source>
        <translation>它是 Git LFS 指针，而不是图像本身（可用 git lfs pull 获取）。</translation>
    </message>
    <message>
        <source>It is not a picture format that can be read as a map: PNG, PGM or BMP.</source>
        <translation>它不是可作为地图读取的图像格式：PNG、PGM 或 BMP。</translation>
    </message>
    <message>
        <source>It is a PNG of colour type %1 with %2 bits per sample, which the format does not allow.</source>
        <translation>它是颜色类型为 %1、每样本 %2 位的 PNG，而该格式不允许这种组合。</translation>
    </message>
    <message>
        <source>It is a PNG with a compression, filter or interlace method that does not exist.</source>
        <translation>这个 PNG 使用了不存在的压缩、滤波或隔行方式。</translation>
    </message>
    <message>
        <source>It starts like a PNG, but its header is not in the right place.</source>
        <translation>它的开头像 PNG，但文件头的位置不对。</translation>
    </message>
    <message>
        <source>It is a PNG with a damaged header (wrong checksum).</source>
        <translation>这个 PNG 的文件头已损坏（校验和错误）。</translation>
    </message>
    <message>
        <source>It is a PNG without pixels.</source>
        <translation>这个 PNG 没有像素。</translation>
    </message>
    <message>
        <source>It is a PNG with a damaged palette (wrong checksum).</source>
        <translation>这个 PNG 的调色板已损坏（校验和错误）。</translation>
    </message>
    <message>
        <source>It is a PNG with a damaged transparency chunk (wrong checksum).</source>
        <translation>这个 PNG 的透明度数据块已损坏（校验和错误）。</translation>
    </message>
    <message>
        <source>It is a PNG with a critical chunk that is not in the standard.</source>
        <translation>这个 PNG 含有标准中没有的关键数据块。</translation>
    </message>
    <message>
        <source>It is a PNG whose palette is missing.</source>
        <translation>这个 PNG 缺少调色板。</translation>
    </message>
    <message>
        <source>a checksum in it is wrong (near byte %1)</source>
        <translation>其中的校验和错误（在第 %1 字节附近）</translation>
    </message>
    <message>
        <source>reading was cancelled</source>
        <translation>读取已取消</translation>
    </message>
    <message>
        <source>Its header says %1 pixels, but its %2 bytes cannot hold so many.</source>
        <translation>文件头说有 %1 个像素，但 %2 字节装不下这么多。</translation>
    </message>
    <message>
        <source>It is an interlaced picture of %1 pixels. Interlaced pictures are read up to %2 bytes unpacked: save it without interlacing.</source>
        <translation>这是一幅 %1 像素的隔行图像。隔行图像解包后最多读取 %2 字节：请以非隔行方式保存。</translation>
    </message>
    <message>
        <source>It is an interlaced picture of %1 pixels, and there is not enough memory to unpack it. Save the picture without interlacing.</source>
        <translation>这是一幅 %1 像素的隔行图像，内存不足以将其解包。请以非隔行方式保存该图像。</translation>
    </message>
    <message>
        <source>The picture %1 was written, but reads back differently</source>
        <translation>图像 %1 已写入，但读回的内容不同</translation>
    </message>
    <message>
        <source>The picture %1 is neither PGM nor PNG: other formats are read-only.</source>
        <translation>图像 %1 既不是 PGM 也不是 PNG：其他格式只读。</translation>
    </message>
    <message>
        <source>No gray level of the picture %1 means %2 by its map.yaml.</source>
        <translation>按图像 %1 的 map.yaml，没有灰度值表示%2。</translation>
    </message>
    <message>
        <source>Temporary files of large maps cannot be kept in %1</source>
        <translation>大地图的临时文件无法存放在 %1</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>磁盘可能已满</translation>
    </message>
</context>
<context>
    <name>history</name>
    <message>
        <source>The versions kept in %1 cannot be read or written</source>
        <translation>保存在 %1 的版本无法读写</translation>
    </message>
    <message>
        <source>Version %1 is damaged on the disk. Nothing is done with it.</source>
        <translation>版本 %1 在磁盘上已损坏，未对它做任何操作。</translation>
    </message>
    <message>
        <source>There is no version %1 here.</source>
        <translation>这里没有版本 %1。</translation>
    </message>
</context>
<context>
    <name>jobs</name>
    <message>
        <source>This version is of another map than &quot;%1&quot;. Pass --map to use it there all the same.</source>
        <translation>该版本属于另一张地图，不是“%1”。仍要在那里使用，请加 --map。</translation>
    </message>
    <message>
        <source>The overlays that the robot holds cannot be read</source>
        <translation>无法读取机器人上的覆盖物</translation>
    </message>
    <message>
        <source>There is no map to export.</source>
        <translation>没有可导出的地图。</translation>
    </message>
    <message>
        <source>The picture for %1 cannot be encoded: %2.</source>
        <translation>%1 的图像无法编码：%2。</translation>
    </message>
    <message>
        <source>Another download into %1 is under way.</source>
        <translation>另一个到 %1 的下载正在进行。</translation>
    </message>
    <message>
        <source>no answer within %1 s</source>
        <translation>%1 s 内没有应答</translation>
    </message>
</context>
<context>
    <name>json</name>
    <message>
        <source>the text ends too early</source>
        <translation>文本过早结束</translation>
    </message>
    <message>
        <source>%1 is expected here</source>
        <translation>此处应为 %1</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>这不是数字</translation>
    </message>
    <message>
        <source>this string has a control character or an unknown escape</source>
        <translation>该字符串含有控制字符或未知的转义</translation>
    </message>
    <message>
        <source>the text is too long</source>
        <translation>文本过长</translation>
    </message>
    <message>
        <source>the text is not UTF-8</source>
        <translation>文本不是 UTF-8</translation>
    </message>
    <message>
        <source>something follows the end of the JSON</source>
        <translation>JSON 结束之后还有内容</translation>
    </message>
    <message>
        <source>objects and lists are nested too deeply</source>
        <translation>对象和列表嵌套过深</translation>
    </message>
    <message>
        <source>a value is expected here</source>
        <translation>此处应为一个值</translation>
    </message>
    <message>
        <source>the name of a member is expected here, in quotes</source>
        <translation>此处应为带引号的成员名</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>第 %1 行第 %2 列</translation>
    </message>
</context>
<context>
    <name>keyring</name>
    <message>
        <source>there is no key ring on this computer</source>
        <translation>这台电脑上没有密钥环</translation>
    </message>
    <message>
        <source>the key ring stays locked</source>
        <translation>密钥环仍处于锁定状态</translation>
    </message>
    <message>
        <source>the key ring does not answer</source>
        <translation>密钥环没有应答</translation>
    </message>
    <message>
        <source>the key ring answered: %1</source>
        <translation>密钥环应答：%1</translation>
    </message>
</context>
<context>
    <name>map</name>
    <message>
        <source>Its resolution is not a number, so its position is unknown.</source>
        <translation>它的分辨率不是数字，因此位置未知。</translation>
    </message>
    <message>
        <source>Its resolution is %1, which is not a valid cell size.</source>
        <translation>它的分辨率为 %1，不是有效的栅格大小。</translation>
    </message>
    <message>
        <source>Its resolution of %1 m is out of range: it must be between 0.1 mm and 1 km.</source>
        <translation>它的分辨率 %1 m 超出范围：必须在 0.1 mm 与 1 km 之间。</translation>
    </message>
    <message>
        <source>Its origin is missing or not a number, so its position is unknown.</source>
        <translation>它的原点缺失或不是数字，因此位置未知。</translation>
    </message>
    <message>
        <source>It is pressed: the robot does not drive until it is released.</source>
        <translation>急停已按下：松开之前机器人不会行驶。</translation>
    </message>
    <message>
        <source>Its origin is more than 10,000 km away, so it cannot be shown.</source>
        <translation>它的原点在 10,000 km 以外，因此无法显示。</translation>
    </message>
    <message>
        <source>The position of the robot on the map may be wrong.</source>
        <translation>机器人在地图上的位置可能有误。</translation>
    </message>
    <message>
        <source>The wheels are released: the robot can be pushed and may roll on a slope.</source>
        <translation>车轮已松开：机器人可以推动，在坡上可能溜车。</translation>
    </message>
    <message>
        <source>The robot does not drive on its own.</source>
        <translation>机器人不会自主行驶。</translation>
    </message>
    <message>
        <source>The robot may be off its position on the map.</source>
        <translation>机器人可能偏离其在地图上的位置。</translation>
    </message>
    <message>
        <source>The robot may not be where its odometry says.</source>
        <translation>机器人可能不在其里程计所示的位置。</translation>
    </message>
    <message>
        <source>The robot gives no further text.</source>
        <translation>机器人没有给出更多说明。</translation>
    </message>
</context>
<context>
    <name>mapwright::edit::OverlayEditing</name>
    <message>
        <source>delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>restore %1</source>
        <translation>恢复 %1</translation>
    </message>
    <message>
        <source>duplicate %1</source>
        <translation>复制 %1 的副本</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>paste %1</source>
        <translation>粘贴 %1</translation>
    </message>
    <message>
        <source>take their version</source>
        <translation>采用对方的版本</translation>
    </message>
    <message>
        <source>discard the changes</source>
        <translation>放弃更改</translation>
    </message>
</context>
<context>
    <name>mapwright::edit::PictureCopies</name>
    <message>
        <source>Its map.yaml was changed afterwards.</source>
        <translation>它的 map.yaml 之后被更改过。</translation>
    </message>
</context>
<context>
    <name>mapwright::edit::PictureEditing</name>
    <message numerus="yes">
        <source>%1 cells</source>
        <translation>
            <numerusform>%1 个栅格</numerusform>
        </translation>
    </message>
    <message>
        <source>eraser</source>
        <translation>橡皮</translation>
    </message>
    <message>
        <source>brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>line</source>
        <translation>线</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>remove specks</source>
        <translation>去除噪点</translation>
    </message>
    <message>
        <source>close gaps</source>
        <translation>填补缝隙</translation>
    </message>
    <message>
        <source>smooth edges</source>
        <translation>平滑边缘</translation>
    </message>
    <message>
        <source>discard changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>take theirs</source>
        <translation>采用对方的</translation>
    </message>
</context>
<context>
    <name>mapwright::robot::files::FileRobot</name>
    <message>
        <source>Folder of maps</source>
        <translation>地图文件夹</translation>
    </message>
    <message>
        <source>Map file</source>
        <translation>地图文件</translation>
    </message>
</context>
<context>
    <name>mapwright::robot::pbstream::StateRobot</name>
    <message>
        <source>Cartographer state file</source>
        <translation>Cartographer 状态文件</translation>
    </message>
    <message>
        <source>Cartographer state file (3D)</source>
        <translation>Cartographer 状态文件（3D）</translation>
    </message>
</context>
<context>
    <name>mapwright::robot::recorded::RecordedRobot</name>
    <message>
        <source>Recording</source>
        <translation>录制文件</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::AdministrationController</name>
    <message>
        <source>Mapping has started: the robot is making a new map.</source>
        <translation>建图已开始：机器人正在建立新地图。</translation>
    </message>
    <message>
        <source>Start &amp;mapping…</source>
        <translation>开始建图(&amp;M)…</translation>
    </message>
    <message>
        <source>Make the robot start a new map</source>
        <translation>让机器人开始建立新地图</translation>
    </message>
    <message>
        <source>E&amp;xtend the map…</source>
        <translation>扩展地图(&amp;X)…</translation>
    </message>
    <message>
        <source>Make the robot map more of its current map</source>
        <translation>让机器人在当前地图上继续建图</translation>
    </message>
    <message>
        <source>S&amp;top mapping…</source>
        <translation>停止建图(&amp;T)…</translation>
    </message>
    <message>
        <source>Make the robot finish its new map</source>
        <translation>让机器人完成新地图</translation>
    </message>
    <message>
        <source>&amp;Discard mapping…</source>
        <translation>放弃建图(&amp;D)…</translation>
    </message>
    <message>
        <source>Make the robot discard what it has mapped since the start</source>
        <translation>让机器人放弃开始以来所建的内容</translation>
    </message>
    <message>
        <source>Save the &amp;new map…</source>
        <translation>保存新地图(&amp;N)…</translation>
    </message>
    <message>
        <source>Store the map that the robot has made, under a name</source>
        <translation>为机器人所建的地图命名并存储</translation>
    </message>
    <message>
        <source>The new map is saved.</source>
        <translation>新地图已保存。</translation>
    </message>
    <message>
        <source>The mapping was discarded: there is no new map.</source>
        <translation>建图已放弃：没有新地图。</translation>
    </message>
    <message>
        <source>The robot is mapping: see the panel Mapping.</source>
        <translation>机器人正在建图：见“建图”面板。</translation>
    </message>
    <message>
        <source>This robot does not send the map while it makes it. It can be seen once it is saved.</source>
        <translation>该机器人建图时不发送地图，保存后才能看到。</translation>
    </message>
    <message>
        <source>Load on the robot…</source>
        <translation>在机器人上加载…</translation>
    </message>
    <message>
        <source>Rename on the robot…</source>
        <translation>在机器人上重命名…</translation>
    </message>
    <message>
        <source>Archive…</source>
        <translation>归档…</translation>
    </message>
    <message>
        <source>Restore from the archive…</source>
        <translation>从归档恢复…</translation>
    </message>
    <message>
        <source>Delete from the robot…</source>
        <translation>从机器人删除…</translation>
    </message>
    <message>
        <source>Load it now…</source>
        <translation>立即加载…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::AppearanceController</name>
    <message>
        <source>Light theme</source>
        <translation>浅色主题</translation>
    </message>
    <message>
        <source>Dark theme</source>
        <translation>深色主题</translation>
    </message>
    <message>
        <source>Theme of the system</source>
        <translation>跟随系统主题</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全屏(&amp;U)</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>使用整个屏幕</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::BagsModel</name>
    <message>
        <source>The robot reports the length when the bag is opened.</source>
        <translation>打开数据包时机器人才会报告长度。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Ended (UTC)</source>
        <translation>结束时间 (UTC)</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CarryDock</name>
    <message>
        <source>Check again</source>
        <translation>重新检查</translation>
    </message>
    <message>
        <source>Find out what becomes of them as the reference map lies now</source>
        <translation>按参考地图当前的位置，查看它们会变成什么</translation>
    </message>
    <message>
        <source>Also adjust to the walls nearby</source>
        <translation>同时按附近的墙微调</translation>
    </message>
    <message>
        <source>Carry over all that are sound</source>
        <translation>迁移所有可靠的</translation>
    </message>
    <message>
        <source>They become changes of the map on screen. Nothing is sent yet.</source>
        <translation>它们会成为屏幕上地图的更改，尚不下发。</translation>
    </message>
    <message>
        <source>Carry over the selected</source>
        <translation>迁移选中项</translation>
    </message>
    <message>
        <source>Also what is not sound, to be placed by hand. Nothing is sent yet. In the list: A</source>
        <translation>不可靠的也一并迁移，由您手动放置，尚不下发。列表中按 A</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>略过</translation>
    </message>
    <message>
        <source>Do not carry over what is selected; once more: do. In the list: X</source>
        <translation>不迁移选中项；再按一次则恢复迁移。列表中按 X</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>可靠</translation>
    </message>
    <message>
        <source>To look at</source>
        <translation>待查看</translation>
    </message>
    <message>
        <source>Which of them are listed</source>
        <translation>列出其中哪些</translation>
    </message>
    <message>
        <source>Move each a little further, to where the walls around it are now</source>
        <translation>把每一项再略微移动，使其与现在周围的墙相符</translation>
    </message>
    <message>
        <source>N and P: the next and the previous that is not decided. A: carry it over. X: leave it out. Enter: show it on the map.</source>
        <translation>N 和 P：下一个、上一个未决定的。A：迁移。X：略过。Enter：在地图上显示。</translation>
    </message>
    <message>
        <source>in an obstacle</source>
        <translation>在障碍物中</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CarryModel</name>
    <message>
        <source>left out</source>
        <translation>已略过</translation>
    </message>
    <message>
        <source>carried over</source>
        <translation>已迁移</translation>
    </message>
    <message>
        <source>%1 sound</source>
        <translation>%1 个可靠</translation>
    </message>
    <message>
        <source>%1 to look at (%2)</source>
        <translation>%1 个待查看（%2）</translation>
    </message>
    <message>
        <source>%1 on the new map already</source>
        <translation>%1 个已在新地图上</translation>
    </message>
    <message>
        <source>%1 left out</source>
        <translation>%1 个已略过</translation>
    </message>
    <message>
        <source>%1 carried over</source>
        <translation>%1 个已迁移</translation>
    </message>
    <message>
        <source>One that belongs to it is on the map on screen already, and stays as it is there.</source>
        <translation>与它相关的一个已在屏幕上的地图中，在那里保持不变。</translation>
    </message>
    <message>
        <source>You left it out. As found: %1</source>
        <translation>您已略过它。查得结果：%1</translation>
    </message>
    <message>
        <source>It goes together with %1.</source>
        <translation>它与%1一起迁移。</translation>
    </message>
    <message>
        <source>How far the walls within 3 m are from where they should be</source>
        <translation>3 m 以内的墙与应在位置的偏差</translation>
    </message>
    <message>
        <source>Became</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>there already</source>
        <translation>已存在</translation>
    </message>
    <message>
        <source>Off (m)</source>
        <translation>偏差 (m)</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::Carrying</name>
    <message>
        <source>There is no reference map.</source>
        <translation>没有参考地图。</translation>
    </message>
    <message>
        <source>There is no whole map on screen.</source>
        <translation>屏幕上没有整张地图。</translation>
    </message>
    <message>
        <source>The map on screen is still being read.</source>
        <translation>屏幕上的地图仍在读取。</translation>
    </message>
    <message>
        <source>The reference map was moved, or one of the maps is another one now. Check again.</source>
        <translation>参考地图被移动过，或其中一张地图已换成另一张。请重新检查。</translation>
    </message>
    <message>
        <source>The map on screen has changed since then. As it was: %1</source>
        <translation>屏幕上的地图此后已更改。当时的结果：%1</translation>
    </message>
    <message>
        <source>Parts of the map on screen could not be read.</source>
        <translation>屏幕上的地图有部分无法读取。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CertificateDialog</name>
    <message>
        <source>Trust this certificate for this robot</source>
        <translation>对该机器人信任此证书</translation>
    </message>
    <message>
        <source>Certificate of %1</source>
        <translation>%1 的证书</translation>
    </message>
    <message>
        <source>The certificate of %1 has changed</source>
        <translation>%1 的证书已改变</translation>
    </message>
    <message>
        <source>The certificate of %1 is not trusted</source>
        <translation>%1 的证书不受信任</translation>
    </message>
    <message>
        <source>Someone may be impersonating the robot, or it was given a new certificate. Nothing has been sent to it. Trust the new certificate only if its fingerprint matches the one that the robot&apos;s administrator gives you.</source>
        <translation>可能有人在冒充该机器人，也可能它换了新证书。尚未向它发送任何内容。只有当新证书的指纹与机器人管理员给您的一致时，才信任它。</translation>
    </message>
    <message>
        <source>No authority that this computer trusts confirms that this is the robot. Nothing has been sent to it. Trust the certificate only if its fingerprint matches the one that the robot&apos;s administrator gives you. From then on only this certificate is accepted.</source>
        <translation>这台电脑所信任的机构中，没有一个能确认这就是该机器人。尚未向它发送任何内容。只有当指纹与机器人管理员给您的一致时，才信任此证书。此后只接受这一张证书。</translation>
    </message>
    <message>
        <source>Do not connect</source>
        <translation>不连接</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Issued for</source>
        <translation>颁发给</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>无名称</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>颁发者</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>有效期</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Trusted until now (SHA-256)</source>
        <translation>此前信任的 (SHA-256)</translation>
    </message>
    <message>
        <source>Now (SHA-256)</source>
        <translation>现在的 (SHA-256)</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>指纹 (SHA-256)</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ChangeDialog</name>
    <message>
        <source>Rename on the robot</source>
        <translation>在机器人上重命名</translation>
    </message>
    <message>
        <source>What should %1 be called?</source>
        <translation>%1 要改成什么名称？</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>It is now called %1.</source>
        <translation>现在名为 %1。</translation>
    </message>
    <message>
        <source>Load on the robot</source>
        <translation>在机器人上加载</translation>
    </message>
    <message>
        <source>The robot will switch from %2 to %1. Its current task may be aborted.</source>
        <translation>机器人将从 %2 切换到 %1。当前任务可能会中止。</translation>
    </message>
    <message>
        <source>The robot will switch to %1. Its current task may be aborted.</source>
        <translation>机器人将切换到 %1。当前任务可能会中止。</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>加载</translation>
    </message>
    <message>
        <source>The robot now uses %1.</source>
        <translation>机器人现在使用 %1。</translation>
    </message>
    <message>
        <source>Archive on the robot</source>
        <translation>在机器人上归档</translation>
    </message>
    <message>
        <source>%1 will be archived. It is not deleted and can be restored.</source>
        <translation>%1 将被归档。它不会被删除，可以恢复。</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>归档</translation>
    </message>
    <message>
        <source>%1 was archived.</source>
        <translation>%1 已归档。</translation>
    </message>
    <message>
        <source>Restore from the archive</source>
        <translation>从归档恢复</translation>
    </message>
    <message>
        <source>%1 will be listed among the robot&apos;s maps again.</source>
        <translation>%1 将重新列入机器人的地图。</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>%1 was restored from the archive.</source>
        <translation>%1 已从归档恢复。</translation>
    </message>
    <message>
        <source>Delete from the robot</source>
        <translation>从机器人删除</translation>
    </message>
    <message>
        <source>This deletes %1 (id %2) and everything on it from the robot. It cannot be undone.</source>
        <translation>这会从机器人删除 %1（编号 %2）及其上的全部内容，无法撤销。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <translation>%1 已删除。</translation>
    </message>
    <message>
        <source>The robot is using it now.</source>
        <translation>机器人正在使用它。</translation>
    </message>
    <message>
        <source>Start mapping</source>
        <translation>开始建图</translation>
    </message>
    <message>
        <source>The robot will leave %1 and start a new map.</source>
        <translation>机器人将离开 %1 并开始建立新地图。</translation>
    </message>
    <message>
        <source>The robot will start a new map.</source>
        <translation>机器人将开始建立新地图。</translation>
    </message>
    <message>
        <source>The robot is mapping.</source>
        <translation>机器人正在建图。</translation>
    </message>
    <message>
        <source>Extend the map</source>
        <translation>扩展地图</translation>
    </message>
    <message>
        <source>The robot will map more of %1, starting at its estimated position. The map does not change until the result is saved.</source>
        <translation>机器人将从其估计位置开始，在 %1 上继续建图。结果保存之前地图不变。</translation>
    </message>
    <message>
        <source>Discard the mapping</source>
        <translation>放弃建图</translation>
    </message>
    <message>
        <source>The robot will stop mapping, and what it has mapped since the start is lost. It cannot be undone.</source>
        <translation>机器人将停止建图，开始以来所建的内容会丢失，无法撤销。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>The mapping was discarded.</source>
        <translation>建图已放弃。</translation>
    </message>
    <message>
        <source>Stop mapping</source>
        <translation>停止建图</translation>
    </message>
    <message>
        <source>The robot will stop mapping. Save the map afterwards, or it may be lost.</source>
        <translation>机器人将停止建图。之后请保存地图，否则可能丢失。</translation>
    </message>
    <message>
        <source>Mapping has stopped.</source>
        <translation>建图已停止。</translation>
    </message>
    <message>
        <source>Save the new map</source>
        <translation>保存新地图</translation>
    </message>
    <message>
        <source>What should the new map be called?</source>
        <translation>新地图叫什么名称？</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>The map was saved as %1.</source>
        <translation>地图已保存为 %1。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>The robot stands at &amp;waypoint</source>
        <translation>机器人停在路径点(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Copy name</source>
        <translation>复制名称(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Type its name or id</source>
        <translation>输入其名称或编号(&amp;T)</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>It already has this name.</source>
        <translation>它已经是这个名称。</translation>
    </message>
    <message>
        <source>Type the name or the id of the map to delete it.</source>
        <translation>要删除地图，请输入其名称或编号。</translation>
    </message>
    <message>
        <source>Waiting for the robot…</source>
        <translation>正在等待机器人…</translation>
    </message>
    <message>
        <source>Cancelling: checking whether the change took effect…</source>
        <translation>正在取消：检查更改是否已生效…</translation>
    </message>
    <message>
        <source>Saving ends the mapping: the robot cannot continue it afterwards.</source>
        <translation>保存会结束建图：之后机器人无法继续建图。</translation>
    </message>
    <message>
        <source>Save and end the mapping</source>
        <translation>保存并结束建图</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ClosuresController</name>
    <message>
        <source>Connect to a robot or open a file to see its loop closures.</source>
        <translation>连接机器人或打开文件，即可查看其回环。</translation>
    </message>
    <message>
        <source>The pose graph is being read.</source>
        <translation>正在读取位姿图。</translation>
    </message>
    <message>
        <source>The pose graph was not read. %1</source>
        <translation>未读取位姿图。%1</translation>
    </message>
    <message>
        <source>The residuals that the robot reports while it maps. It does not say which submaps and nodes they tie together.</source>
        <translation>这是机器人建图时报告的残差。它没有说明这些残差关联哪些子图和节点。</translation>
    </message>
    <message>
        <source>No loop was closed: this map is odometry and scan matching only.</source>
        <translation>没有回环：这张地图只靠里程计和扫描匹配。</translation>
    </message>
    <message numerus="yes">
        <source>%1 loop closures.</source>
        <translation>
            <numerusform>%1 个回环。</numerusform>
        </translation>
    </message>
    <message>
        <source>None contradicts the finished map by more than 0.5 m.</source>
        <translation>没有与完成的地图相差超过 0.5 m 的。</translation>
    </message>
    <message numerus="yes">
        <source>%1 contradict the finished map by more than 0.5 m.</source>
        <translation>
            <numerusform>%1 个与完成的地图相差超过 0.5 m。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 are not listed: their submap or node is not there.</source>
        <translation>
            <numerusform>%1 个未列出：其子图或节点不存在。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 are not listed: they have no valid pose.</source>
        <translation>
            <numerusform>%1 个未列出：没有有效的位姿。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ClosuresDock</name>
    <message>
        <source>Loop closures</source>
        <translation>回环</translation>
    </message>
    <message>
        <source>By submap</source>
        <translation>按子图</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>在地图上</translation>
    </message>
    <message>
        <source>Submap or node, as 0-12</source>
        <translation>子图或节点，如 0-12</translation>
    </message>
    <message>
        <source>Search submaps and nodes</source>
        <translation>搜索子图和节点</translation>
    </message>
    <message>
        <source>Within submaps</source>
        <translation>子图内部</translation>
    </message>
    <message>
        <source>All constraints</source>
        <translation>全部约束</translation>
    </message>
    <message>
        <source>Which constraints are listed</source>
        <translation>列出哪些约束</translation>
    </message>
    <message>
        <source>Loop closures tie the robot to a submap of an earlier visit (INTER_SUBMAP); the others to the submap that was being made (INTRA_SUBMAP)</source>
        <translation>回环把机器人与先前经过时的子图关联 (INTER_SUBMAP)；其余约束则与当时正在建立的子图关联 (INTRA_SUBMAP)</translation>
    </message>
    <message>
        <source>from </source>
        <translation>不小于 </translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Smallest residual that is listed</source>
        <translation>列出的最小残差</translation>
    </message>
    <message>
        <source>One row for each submap: its worst constraint, and how many contradict the map; Enter lists them</source>
        <translation>每个子图一行：其最差的约束，以及有多少个与地图矛盾；按 Enter 列出</translation>
    </message>
    <message>
        <source>List the constraints of all submaps again</source>
        <translation>重新列出所有子图的约束</translation>
    </message>
    <message>
        <source>Constraints</source>
        <translation>约束</translation>
    </message>
    <message>
        <source>Lies at %1
Expected at %2</source>
        <translation>位于 %1
应在 %2</translation>
    </message>
    <message>
        <source>Choose a row, or click its line on the map, to see where it lies.</source>
        <translation>选择一行，或单击地图上对应的线，查看其位置。</translation>
    </message>
    <message>
        <source>Choose a row to see where it lies.</source>
        <translation>选择一行以查看其位置。</translation>
    </message>
    <message>
        <source>Draw loop closures on the map, coloured by how much they contradict it</source>
        <translation>在地图上绘制回环，按与地图矛盾的程度着色</translation>
    </message>
    <message>
        <source>Those that are not listed are not drawn while this panel is open</source>
        <translation>此面板打开时，未列出的不绘制</translation>
    </message>
    <message>
        <source>Submap %1</source>
        <translation>子图 %1</translation>
    </message>
    <message>
        <source>A robot that maps does not name the submaps of its constraints.</source>
        <translation>正在建图的机器人不说明其约束属于哪些子图。</translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps</source>
        <translation>
            <numerusform>%1 个子图</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 constraints, and only these on the map</source>
        <translation>%1 / %2 个约束，地图上也只有这些</translation>
    </message>
    <message>
        <source>%1 of %2 constraints</source>
        <translation>%1 / %2 个约束</translation>
    </message>
    <message numerus="yes">
        <source>%1 constraints</source>
        <translation>
            <numerusform>%1 个约束</numerusform>
        </translation>
    </message>
    <message>
        <source>Show on the map</source>
        <translation>在地图上显示</translation>
    </message>
    <message>
        <source>List its constraints</source>
        <translation>列出其约束</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ClosuresModel</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>How far the constraint has the robot from where the finished map has it, metres</source>
        <translation>约束所得的机器人位置与完成的地图相差多少米</translation>
    </message>
    <message>
        <source>The same for its heading, degrees</source>
        <translation>朝向相差多少度</translation>
    </message>
    <message>
        <source>How many of its constraints contradict the finished map by more than 0.5 m</source>
        <translation>其约束中有多少个与完成的地图相差超过 0.5 m</translation>
    </message>
    <message>
        <source>Off, m</source>
        <translation>残差 (m)</translation>
    </message>
    <message>
        <source>Turn, °</source>
        <translation>转角 (°)</translation>
    </message>
    <message>
        <source>Submap</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Over 0.5 m</source>
        <translation>超过 0.5 m</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CloudsController</name>
    <message>
        <source>Fetch clou&amp;d of region</source>
        <translation>获取区域点云(&amp;D)</translation>
    </message>
    <message>
        <source>Draw a region and fetch its cloud</source>
        <translation>画一个区域并获取其点云</translation>
    </message>
    <message>
        <source>S&amp;ection</source>
        <translation>剖面(&amp;E)</translation>
    </message>
    <message>
        <source>Drag a line to see a cross-section of a cloud</source>
        <translation>拖一条线，查看点云的剖面</translation>
    </message>
    <message>
        <source>Connect to a robot with a map dispatcher to see its 3D map.</source>
        <translation>连接带地图分发器的机器人，即可查看其 3D 地图。</translation>
    </message>
    <message>
        <source>This robot does not offer a cloud of its occupied cells.</source>
        <translation>该机器人不提供占据栅格的点云。</translation>
    </message>
    <message>
        <source>This robot does not offer a cloud of its points.</source>
        <translation>该机器人不提供其点的点云。</translation>
    </message>
    <message>
        <source>The lowest and the highest height to fetch are the same.</source>
        <translation>要获取的最低高度与最高高度相同。</translation>
    </message>
    <message>
        <source>A cloud is already being fetched.</source>
        <translation>已有点云正在获取。</translation>
    </message>
    <message>
        <source>Fetching…</source>
        <translation>正在获取…</translation>
    </message>
    <message>
        <source>Fetching… %1</source>
        <translation>正在获取… %1</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>The robot answered with another region.</source>
        <translation>机器人应答的是另一个分块。</translation>
    </message>
    <message>
        <source>The robot has no points in this region.</source>
        <translation>机器人在此区域没有点。</translation>
    </message>
    <message numerus="yes">
        <source>%1 points were received.</source>
        <translation>
            <numerusform>已收到 %1 个点。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>clouds of %1 points</source>
        <translation>
            <numerusform>%1 个点的点云</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the displayed cloud</source>
        <translation>保存所显示的点云</translation>
    </message>
    <message>
        <source>Clouds (*.pcd *.ply *.csv)</source>
        <translation>点云 (*.pcd *.ply *.csv)</translation>
    </message>
    <message>
        <source>A cloud can be saved as .pcd, .ply or .csv. Choose one of these.</source>
        <translation>点云可保存为 .pcd、.ply 或 .csv，请选择其一。</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CloudsDock</name>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>点云</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>获取</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Occupied cells</source>
        <translation>占据栅格</translation>
    </message>
    <message>
        <source>What to fetch</source>
        <translation>要获取的内容</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Lowest height to fetch</source>
        <translation>获取的最低高度</translation>
    </message>
    <message>
        <source>Highest height to fetch</source>
        <translation>获取的最高高度</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>方框</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>Shape of the region</source>
        <translation>区域的形状</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>视图内</translation>
    </message>
    <message>
        <source>Draw region</source>
        <translation>画区域</translation>
    </message>
    <message>
        <source>Everything…</source>
        <translation>全部…</translation>
    </message>
    <message>
        <source>The robot does not report the size of its whole cloud. Fetching it may need much time and memory.</source>
        <translation>机器人没有报告整个点云的大小。获取它可能需要很多时间和内存。</translation>
    </message>
    <message>
        <source>Fetch everything</source>
        <translation>获取全部</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Colour of the points</source>
        <translation>点的颜色</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Size of the points</source>
        <translation>点的大小</translation>
    </message>
    <message>
        <source>Point size</source>
        <translation>点大小</translation>
    </message>
    <message>
        <source>Size of the cells</source>
        <translation>栅格的大小</translation>
    </message>
    <message>
        <source>detected</source>
        <translation>自动检测</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>栅格大小</translation>
    </message>
    <message>
        <source>Lowest height to show</source>
        <translation>显示的最低高度</translation>
    </message>
    <message>
        <source>Highest height to show</source>
        <translation>显示的最高高度</translation>
    </message>
    <message>
        <source>All heights</source>
        <translation>全部高度</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Preparing the cloud…</source>
        <translation>正在准备点云…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CollectionDialog</name>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Defaults of the map</source>
        <translation>地图的默认值</translation>
    </message>
    <message>
        <source>Rack width</source>
        <translation>货架宽度</translation>
    </message>
    <message>
        <source>Rack depth</source>
        <translation>货架深度</translation>
    </message>
    <message>
        <source>Pallet width</source>
        <translation>托盘宽度</translation>
    </message>
    <message>
        <source>Pallet depth</source>
        <translation>托盘深度</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>未设置</translation>
    </message>
    <message>
        <source>Racks and pallets of this map have these sizes where nothing else is given. Can be undone; sent when you save.</source>
        <translation>此地图的货架和托盘在未另行说明时采用这些尺寸。可以撤销；保存时下发。</translation>
    </message>
    <message>
        <source>Kept as they are: %1</source>
        <translation>保持原样：%1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ColorScale</name>
    <message>
        <source>Colours by height, from %1 to %2</source>
        <translation>按高度着色，从 %1 到 %2</translation>
    </message>
    <message>
        <source>Colours by intensity, from %1 to %2</source>
        <translation>按强度着色，从 %1 到 %2</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CommandPalette</name>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>A command, or the name of an object, submap, map or topic</source>
        <translation>命令，或对象、子图、地图、话题的名称</translation>
    </message>
    <message>
        <source>Command or name</source>
        <translation>命令或名称</translation>
    </message>
    <message>
        <source>  (on)</source>
        <translation>  （开）</translation>
    </message>
    <message>
        <source>Nothing is called that</source>
        <translation>没有叫这个名称的</translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed: type more of the name</source>
        <translation>
            <numerusform>还有 %1 个未列出：请输入更多名称</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CompareBar</name>
    <message>
        <source>new since then</source>
        <translation>此后新增</translation>
    </message>
    <message>
        <source>new in the second</source>
        <translation>第二张中新增</translation>
    </message>
    <message>
        <source>gone since then</source>
        <translation>此后消失</translation>
    </message>
    <message>
        <source>gone in the second</source>
        <translation>第二张中消失</translation>
    </message>
    <message>
        <source>known then only</source>
        <translation>仅当时已知</translation>
    </message>
    <message>
        <source>known in the first only</source>
        <translation>仅第一张中已知</translation>
    </message>
    <message>
        <source>known now only</source>
        <translation>仅现在已知</translation>
    </message>
    <message>
        <source>known in the second only</source>
        <translation>仅第二张中已知</translation>
    </message>
    <message>
        <source>Stop comparing (Esc)</source>
        <translation>停止比较 (Esc)</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>停止比较</translation>
    </message>
    <message>
        <source>Second map</source>
        <translation>第二张地图</translation>
    </message>
    <message>
        <source>The map to compare the open one with</source>
        <translation>与打开的地图比较的地图</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>滑动对比</translation>
    </message>
    <message>
        <source>One map to the left of a divider, the other to the right; drag it</source>
        <translation>分隔线左边一张地图，右边另一张；可拖动分隔线</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Fetching the map</source>
        <translation>正在获取地图</translation>
    </message>
    <message>
        <source>with</source>
        <translation>与</translation>
    </message>
    <message>
        <source>the submaps (they are on the left)</source>
        <translation>子图（它们在左边）</translation>
    </message>
    <message>
        <source>Live map</source>
        <translation>实时地图</translation>
    </message>
    <message>
        <source>  current</source>
        <translation>  当前</translation>
    </message>
    <message>
        <source>The state before</source>
        <translation>先前的状态</translation>
    </message>
    <message>
        <source>Keep the current state</source>
        <translation>保留当前状态</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>文件…</translation>
    </message>
    <message>
        <source>Choose a map</source>
        <translation>选择地图</translation>
    </message>
    <message>
        <source>A difference needs two whole maps</source>
        <translation>求差异需要两张整张地图</translation>
    </message>
    <message>
        <source>Show the differences in colour</source>
        <translation>用颜色显示差异</translation>
    </message>
    <message>
        <source>Choose a map to compare the open one with.</source>
        <translation>选择一张地图与打开的地图比较。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CompareController</name>
    <message>
        <source>Com&amp;pare…</source>
        <translation>比较(&amp;P)…</translation>
    </message>
    <message>
        <source>Compare maps…</source>
        <translation>比较地图…</translation>
    </message>
    <message>
        <source>Compare the open map with another one</source>
        <translation>将打开的地图与另一张比较</translation>
    </message>
    <message>
        <source>Compare with a map file</source>
        <translation>与地图文件比较</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>This is not a map file.</source>
        <translation>这不是地图文件。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ConflictBox</name>
    <message>
        <source>Keep mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>Keep the change made here: the filled triangle on the map</source>
        <translation>保留在这里所做的更改：地图上的实心三角</translation>
    </message>
    <message>
        <source>Take theirs</source>
        <translation>采用对方的</translation>
    </message>
    <message>
        <source>Keep the change made elsewhere: the hollow triangle on the map</source>
        <translation>保留在别处所做的更改：地图上的空心三角</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>两者都保留</translation>
    </message>
    <message>
        <source>Keep theirs, and mine as a second waypoint with its own name</source>
        <translation>保留对方的，并把我的作为另一个有自己名称的路径点</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Show both on the map</source>
        <translation>在地图上显示两者</translation>
    </message>
    <message>
        <source>Previous conflict</source>
        <translation>上一个冲突</translation>
    </message>
    <message>
        <source>Next conflict</source>
        <translation>下一个冲突</translation>
    </message>
    <message>
        <source>%1 was changed here and elsewhere.</source>
        <translation>%1 在这里和别处都被更改。</translation>
    </message>
    <message>
        <source>%1 was changed here and elsewhere (%2 of %3).</source>
        <translation>%1 在这里和别处都被更改（%2 / %3）。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ConnectDialog</name>
    <message>
        <source>Encr&amp;ypted (TLS)</source>
        <translation>加密 (TLS)(&amp;Y)</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>连接机器人</translation>
    </message>
    <message>
        <source>Try the demo robot</source>
        <translation>试用演示机器人</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>This robot asks for one</source>
        <translation>该机器人要求提供</translation>
    </message>
    <message>
        <source>Only if the robot asks for one</source>
        <translation>仅在机器人要求时</translation>
    </message>
    <message>
        <source>Find out what answers there</source>
        <translation>查找该地址上的机器人</translation>
    </message>
    <message>
        <source>As its address says</source>
        <translation>按其地址</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Port </source>
        <translation>端口 </translation>
    </message>
    <message>
        <source>What you call it, for example Dock 3</source>
        <translation>您对它的称呼，例如 3 号对接点</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>机器人(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>地址(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Secret</source>
        <translation>密钥(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Recent robots</source>
        <translation>最近的机器人</translation>
    </message>
    <message>
        <source>Recent robots and files</source>
        <translation>最近的机器人和文件</translation>
    </message>
    <message>
        <source>Forget this file</source>
        <translation>忘记此文件</translation>
    </message>
    <message>
        <source>Forget this robot</source>
        <translation>忘记此机器人</translation>
    </message>
    <message>
        <source>Forget %1</source>
        <translation>忘记 %1</translation>
    </message>
    <message>
        <source>None yet. What you connect to or open is listed here.</source>
        <translation>暂无。您连接或打开过的会列在这里。</translation>
    </message>
    <message>
        <source>A port is a number from 1 to %1.</source>
        <translation>端口是 1 到 %1 的数字。</translation>
    </message>
    <message>
        <source>Searches for every kind of robot at %1. No secret is sent.</source>
        <translation>在 %1 搜索各种机器人，不发送密钥。</translation>
    </message>
    <message>
        <source>The name or address of the robot&apos;s computer.</source>
        <translation>机器人电脑的名称或地址。</translation>
    </message>
    <message>
        <source>A host such as 192.0.2.7 or dock-3.local:9090, or a full address such as %1.</source>
        <translation>主机如 192.0.2.7 或 dock-3.local:9090，或完整地址如 %1。</translation>
    </message>
    <message>
        <source>Connects to %1</source>
        <translation>连接到 %1</translation>
    </message>
    <message>
        <source>Opens %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>%1. The address overrides the kind chosen above.</source>
        <translation>%1。该地址优先于上面所选的类型。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ConnectionChip</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ConnectionController</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近的(&amp;R)</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation>连接(&amp;C)…</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>连接机器人</translation>
    </message>
    <message>
        <source>Try the &amp;demo robot</source>
        <translation>试用演示机器人(&amp;D)</translation>
    </message>
    <message>
        <source>Connect to a simulated robot inside this program</source>
        <translation>连接到本程序内的模拟机器人</translation>
    </message>
    <message>
        <source>&amp;Retry now</source>
        <translation>立即重试(&amp;R)</translation>
    </message>
    <message>
        <source>Reconnect, and repeat every request that failed</source>
        <translation>重新连接，并重复所有失败的请求</translation>
    </message>
    <message>
        <source>D&amp;isconnect</source>
        <translation>断开连接(&amp;I)</translation>
    </message>
    <message>
        <source>Disconnect from this robot</source>
        <translation>断开与该机器人的连接</translation>
    </message>
    <message>
        <source>&amp;Close file</source>
        <translation>关闭文件(&amp;C)</translation>
    </message>
    <message>
        <source>Close this file</source>
        <translation>关闭此文件</translation>
    </message>
    <message>
        <source>&amp;Read again</source>
        <translation>重新读取(&amp;R)</translation>
    </message>
    <message>
        <source>Read this file again</source>
        <translation>重新读取此文件</translation>
    </message>
    <message>
        <source>&amp;Name and colour…</source>
        <translation>名称和颜色(&amp;N)…</translation>
    </message>
    <message>
        <source>Your own name and colour for this robot</source>
        <translation>您为该机器人取的名称和颜色</translation>
    </message>
    <message>
        <source>Recent robots</source>
        <translation>最近的机器人</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>The stored secret cannot be read. %1</source>
        <translation>无法读取已存的密钥。%1</translation>
    </message>
    <message>
        <source>No robot supports this address.</source>
        <translation>没有机器人支持此地址。</translation>
    </message>
    <message>
        <source>Keep the secret?</source>
        <translation>保留密钥？</translation>
    </message>
    <message>
        <source>Keep the secret of %1 in the key ring of this computer?</source>
        <translation>把 %1 的密钥保存在这台电脑的密钥环中？</translation>
    </message>
    <message>
        <source>It will be used from there. It is stored nowhere else, and removed when you forget the robot.</source>
        <translation>以后从那里取用。密钥不存放在别处，忘记该机器人时会一并移除。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Never for this robot</source>
        <translation>对该机器人始终不保留</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>暂不</translation>
    </message>
    <message>
        <source>The secret is in the key ring.</source>
        <translation>密钥已存入密钥环。</translation>
    </message>
    <message>
        <source>The secret was not stored. %1</source>
        <translation>密钥未存储。%1</translation>
    </message>
    <message>
        <source>The secret could not be removed from the key ring. %1</source>
        <translation>无法从密钥环移除密钥。%1</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>连接…</translation>
    </message>
    <message>
        <source>The layout and the recent robots cannot be saved: %1 is not writable. Is the disk full?</source>
        <translation>无法保存布局和最近的机器人：%1 不可写。磁盘是否已满？</translation>
    </message>
    <message>
        <source>The robot started a new SLAM session. The previous map is gone.</source>
        <translation>机器人开始了新的 SLAM 会话，先前的地图已不存在。</translation>
    </message>
    <message>
        <source>A file is open, and no robot connected: see the menu File.</source>
        <translation>打开的是文件，没有连接机器人：见“文件”菜单。</translation>
    </message>
    <message>
        <source>No robot</source>
        <translation>没有机器人</translation>
    </message>
    <message>
        <source>Model %1</source>
        <translation>型号 %1</translation>
    </message>
    <message>
        <source>Serial number %1</source>
        <translation>序列号 %1</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>版本 %1</translation>
    </message>
    <message>
        <source>replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>file, not open</source>
        <translation>文件，未打开</translation>
    </message>
    <message>
        <source>No connection since %1, %2</source>
        <translation>自 %1 起没有连接，%2</translation>
    </message>
    <message>
        <source>Enter secret…</source>
        <translation>输入密钥…</translation>
    </message>
    <message>
        <source>Certificate…</source>
        <translation>证书…</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>重新读取</translation>
    </message>
    <message>
        <source>Retry now</source>
        <translation>立即重试</translation>
    </message>
    <message>
        <source>The certificate of %1 is not trusted: the robot&apos;s pose and sensor data are missing.</source>
        <translation>%1 的证书不受信任：缺少机器人的位姿和传感器数据。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::CopiesDialog</name>
    <message>
        <source>&amp;Put back…</source>
        <translation>放回(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>Show in &amp;folder</source>
        <translation>在文件夹中显示(&amp;F)</translation>
    </message>
    <message>
        <source>Copies of overwritten maps</source>
        <translation>被覆盖地图的备份</translation>
    </message>
    <message>
        <source>Before a robot&apos;s map is overwritten, its old picture is kept in %1: the newest %2 of each map, and at most %3 in all.</source>
        <translation>覆盖机器人的地图之前，其旧图像会保存在 %1：每张地图保留最新的 %2 个，总共不超过 %3。</translation>
    </message>
    <message>
        <source>Overwritten</source>
        <translation>覆盖时间</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>%1 x %2 cells, %3</source>
        <translation>%1 x %2 个栅格，%3</translation>
    </message>
    <message>
        <source>Show it as an unsaved change of the map on screen, to look at before it is sent</source>
        <translation>作为屏幕上地图的未保存更改显示，下发前可先查看</translation>
    </message>
    <message>
        <source>Open it as a local map</source>
        <translation>作为本地地图打开</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>Looking for copies…</source>
        <translation>正在查找副本…</translation>
    </message>
    <message>
        <source>There are none yet.</source>
        <translation>暂无。</translation>
    </message>
    <message>
        <source>This copy cannot be read.</source>
        <translation>此副本无法读取。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::DiagnosticsDialog</name>
    <message>
        <source>Diagnostics</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>One per processor</source>
        <translation>每个处理器一个</translation>
    </message>
    <message>
        <source> MiB</source>
        <translation> MiB</translation>
    </message>
    <message>
        <source>Default (%1 MiB)</source>
        <translation>默认（%1 MiB）</translation>
    </message>
    <message>
        <source>Takes effect at the next start</source>
        <translation>下次启动时生效</translation>
    </message>
    <message>
        <source>&amp;Threads</source>
        <translation>线程数(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Memory</source>
        <translation>内存(&amp;M)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>&amp;Copy diagnostics</source>
        <translation>复制诊断信息(&amp;C)</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::DisagreementController</name>
    <message>
        <source>Connect to a robot or open a file to see where submaps contradict each other.</source>
        <translation>连接机器人或打开文件，即可查看子图在哪里相互矛盾。</translation>
    </message>
    <message>
        <source>No submaps are on the map so far.</source>
        <translation>目前地图上没有子图。</translation>
    </message>
    <message>
        <source>%1 % of the occupied cells are contradicted by another submap: %2 of %3, each %4 cm wide.</source>
        <translation>%1% 的占据栅格与另一子图矛盾：%3 个中的 %2 个，每个宽 %4 cm。</translation>
    </message>
    <message>
        <source>The map is still being looked at.</source>
        <translation>地图仍在检查。</translation>
    </message>
    <message>
        <source>The worst %1 of %2 places are listed.</source>
        <translation>列出 %2 处中最差的 %1 处。</translation>
    </message>
    <message>
        <source>No submaps contradict each other here.</source>
        <translation>这里没有子图相互矛盾。</translation>
    </message>
    <message>
        <source>No contradiction was found so far.</source>
        <translation>目前没有发现矛盾。</translation>
    </message>
    <message>
        <source>%1 of %2 squares of the map are looked at so far.</source>
        <translation>地图的 %2 个方块中已检查 %1 个。</translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps are still missing.</source>
        <translation>
            <numerusform>仍缺少 %1 个子图。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 hidden submaps do not count.</source>
        <translation>
            <numerusform>%1 个隐藏的子图不计入。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps are too far away to count.</source>
        <translation>
            <numerusform>%1 个子图太远，不计入。</numerusform>
        </translation>
    </message>
    <message>
        <source>Submap %1 is hidden.</source>
        <translation>子图 %1 已隐藏。</translation>
    </message>
    <message>
        <source>Submap %1 is shown.</source>
        <translation>子图 %1 已显示。</translation>
    </message>
    <message>
        <source>Submap %1, %2 of %3, otherwise hidden: %4</source>
        <translation>子图 %1，%2 / %3，其余隐藏：%4</translation>
    </message>
    <message>
        <source>Submap %1, %2 of %3: %4</source>
        <translation>子图 %1，%2 / %3：%4</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::DisagreementDock</name>
    <message>
        <source>Disagreement</source>
        <translation>不一致</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>在地图上</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>闪烁</translation>
    </message>
    <message>
        <source>Show the submaps that disagree in turn</source>
        <translation>轮流显示不一致的子图</translation>
    </message>
    <message>
        <source>Next submap</source>
        <translation>下一个子图</translation>
    </message>
    <message>
        <source>Of those that disagree, show only the next one</source>
        <translation>不一致的子图中，只显示下一个</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Show everything as before</source>
        <translation>恢复全部显示</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show hidden</source>
        <translation>显示隐藏的</translation>
    </message>
    <message>
        <source>Show all submaps that you have hidden</source>
        <translation>显示您隐藏的所有子图</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>精确</translation>
    </message>
    <message numerus="yes">
        <source>Within %1 cells</source>
        <translation>
            <numerusform>%1 个栅格以内</numerusform>
        </translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>Show the layer Disagreement</source>
        <translation>显示“不一致”图层</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Places where submaps disagree</source>
        <translation>子图不一致的位置</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Show this submap on the map again</source>
        <translation>在地图上重新显示此子图</translation>
    </message>
    <message>
        <source>Hide this submap, as in the SLAM inspector, and show the others</source>
        <translation>隐藏此子图（同 SLAM 检查器），并显示其他子图</translation>
    </message>
    <message>
        <source>A wall that is seen a cell beside contradicts</source>
        <translation>墙偏了一个栅格就算矛盾</translation>
    </message>
    <message>
        <source>A wall that is seen up to %1 cm beside is the same wall</source>
        <translation>墙偏差不超过 %1 cm 仍算同一面墙</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::EditController</name>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>撤销上一个更改</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Redo the change that was undone last</source>
        <translation>重做上次撤销的更改</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the changes</source>
        <translation>保存更改</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Original state</source>
        <translation>原始状态</translation>
    </message>
    <message>
        <source>Steps that can be undone</source>
        <translation>可以撤销的步骤</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::EditorController</name>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>The robot changed to another map at %1. %2</source>
        <translation>机器人在 %1 切换到了另一张地图。%2</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>显示它</translation>
    </message>
    <message>
        <source>The changes are being saved, and cannot be discarded until that has ended.</source>
        <translation>更改正在保存，保存结束之前无法放弃。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::EmptyStateCard</name>
    <message>
        <source>The certificate of the robot has changed</source>
        <translation>机器人的证书已改变</translation>
    </message>
    <message>
        <source>The certificate of the robot is not trusted</source>
        <translation>机器人的证书不受信任</translation>
    </message>
    <message>
        <source>Enter secret…</source>
        <translation>输入密钥…</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>连接…</translation>
    </message>
    <message>
        <source>Try the demo robot</source>
        <translation>试用演示机器人</translation>
    </message>
    <message>
        <source>Open a map file…</source>
        <translation>打开地图文件…</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Certificate…</source>
        <translation>证书…</translation>
    </message>
    <message>
        <source>Fetch clouds…</source>
        <translation>获取点云…</translation>
    </message>
    <message>
        <source>Other robot…</source>
        <translation>其他机器人…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::EventsDock</name>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Search events</source>
        <translation>搜索事件</translation>
    </message>
    <message>
        <source>Read the rest</source>
        <translation>读取其余部分</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>所有类型</translation>
    </message>
    <message>
        <source>Kind of event</source>
        <translation>事件类型</translation>
    </message>
    <message>
        <source>Which kinds of events to list</source>
        <translation>列出哪些类型的事件</translation>
    </message>
    <message>
        <source>Follow the time</source>
        <translation>跟随时间</translation>
    </message>
    <message>
        <source>Scroll to the event at the current time</source>
        <translation>滚动到当前时间的事件</translation>
    </message>
    <message>
        <source>Read to the end to find all events</source>
        <translation>读到结尾以找出所有事件</translation>
    </message>
    <message>
        <source>Retry what could not be loaded</source>
        <translation>重试未能加载的内容</translation>
    </message>
    <message>
        <source>Save the listed events as CSV</source>
        <translation>把列出的事件保存为 CSV</translation>
    </message>
    <message numerus="yes">
        <source>%1 events</source>
        <translation>
            <numerusform>%1 个事件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1: the whole bag has been read</source>
        <translation>%1：整个数据包已读完</translation>
    </message>
    <message>
        <source>%1 found so far: %2 % of the bag has been read</source>
        <translation>目前找到 %1：数据包已读取 %2%</translation>
    </message>
    <message>
        <source>The events of a bag are listed here while it is replayed.</source>
        <translation>回放数据包时，其事件列在这里。</translation>
    </message>
    <message>
        <source>No events found so far.</source>
        <translation>目前没有找到事件。</translation>
    </message>
    <message>
        <source>This bag has no events.</source>
        <translation>此数据包没有事件。</translation>
    </message>
    <message>
        <source>No event matches the search.</source>
        <translation>没有符合搜索的事件。</translation>
    </message>
    <message numerus="yes">
        <source>%1 events copied</source>
        <translation>
            <numerusform>已复制 %1 个事件</numerusform>
        </translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>转到那里</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>全选</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::EventsModel</name>
    <message>
        <source>Time (UTC)</source>
        <translation>时间 (UTC)</translation>
    </message>
    <message>
        <source>Since start</source>
        <translation>自开始</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ExpectedController</name>
    <message>
        <source>Everywhere: %1</source>
        <translation>各处：%1</translation>
    </message>
    <message>
        <source>There or elsewhere: %1</source>
        <translation>该处或别处：%1</translation>
    </message>
    <message>
        <source>Elsewhere: %1</source>
        <translation>别处：%1</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>差异内容</translation>
    </message>
    <message>
        <source>Compare &amp;with expected…</source>
        <translation>与期望图像比较(&amp;W)…</translation>
    </message>
    <message>
        <source>Compare the map with an expected picture of the same place</source>
        <translation>将地图与同一地点的期望图像比较</translation>
    </message>
    <message>
        <source>Compare with an expected picture</source>
        <translation>与期望图像比较</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>No report beside %1 says which part of the map it shows. snapshot --report and suite accept write one.</source>
        <translation>%1 旁边没有报告说明它显示地图的哪一部分。snapshot --report 和 suite accept 会写出这种报告。</translation>
    </message>
    <message>
        <source>%1 is too large to be compared here. The command suite has no such limit.</source>
        <translation>%1 太大，无法在这里比较。命令 suite 没有此限制。</translation>
    </message>
    <message>
        <source>There is not enough room to draw the map again.</source>
        <translation>空间不足，无法再绘制一次地图。</translation>
    </message>
    <message>
        <source>The robot is not connected, so not everything has arrived.</source>
        <translation>机器人未连接，因此内容没有全部到达。</translation>
    </message>
    <message>
        <source>Nothing has come from the robot since %1, so not everything has arrived.</source>
        <translation>自 %1 起没有收到机器人的任何内容，因此内容没有全部到达。</translation>
    </message>
    <message>
        <source>Not everything had arrived within %1 s.</source>
        <translation>%1 s 内内容没有全部到达。</translation>
    </message>
    <message>
        <source>Compared with the expected picture</source>
        <translation>已与期望图像比较</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>期望</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>Expected and now</source>
        <translation>期望与现在</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>改变的内容</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ExportController</name>
    <message>
        <source>E&amp;xport…</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>Export the map…</source>
        <translation>导出地图…</translation>
    </message>
    <message>
        <source>Write the map on screen to a file</source>
        <translation>把屏幕上的地图写入文件</translation>
    </message>
    <message>
        <source>Copy pict&amp;ure</source>
        <translation>复制图像(&amp;U)</translation>
    </message>
    <message>
        <source>Copy the map as a picture</source>
        <translation>把地图复制为图像</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>保存图像(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the map as a PNG picture</source>
        <translation>把地图保存为 PNG 图像</translation>
    </message>
    <message>
        <source>The map was read from %1. Choose another name.</source>
        <translation>地图是从 %1 读取的，请另选名称。</translation>
    </message>
    <message>
        <source>Picture copied</source>
        <translation>图像已复制</translation>
    </message>
    <message>
        <source>Save the map as a picture</source>
        <translation>把地图保存为图像</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>The map is still loading.</source>
        <translation>地图仍在加载。</translation>
    </message>
    <message>
        <source>There is no open map, and there are no submaps.</source>
        <translation>没有打开的地图，也没有子图。</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>已导出到 %1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ExportDialog</name>
    <message>
        <source>&amp;Picture of the map (PNG)</source>
        <translation>地图图像 (PNG)(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;ROS map (PGM and YAML, for map_server)</source>
        <translation>ROS 地图（PGM 和 YAML，供 map_server 使用）(&amp;R)</translation>
    </message>
    <message>
        <source>Picture of the current &amp;view (PNG)</source>
        <translation>当前视图的图像 (PNG)(&amp;V)</translation>
    </message>
    <message>
        <source>W&amp;ith a world file (.pgw) that gives its position</source>
        <translation>附带给出其位置的世界文件 (.pgw)(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Thresholds</source>
        <translation>阈值(&amp;T)</translation>
    </message>
    <message>
        <source>Occupied above</source>
        <translation>占据：高于</translation>
    </message>
    <message>
        <source>Cells of a higher probability are walls</source>
        <translation>概率更高的栅格是墙</translation>
    </message>
    <message>
        <source>Free below</source>
        <translation>空闲：低于</translation>
    </message>
    <message>
        <source>Cells of a lower probability are free</source>
        <translation>概率更低的栅格是空闲</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>浏览(&amp;B)…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>内容(&amp;W)</translation>
    </message>
    <message>
        <source>Metres per &amp;cell</source>
        <translation>每栅格米数(&amp;C)</translation>
    </message>
    <message>
        <source>Map &amp;mode</source>
        <translation>地图模式(&amp;M)</translation>
    </message>
    <message>
        <source>The whole map</source>
        <translation>整张地图</translation>
    </message>
    <message>
        <source>The submaps, composed</source>
        <translation>子图合成</translation>
    </message>
    <message>
        <source>&amp;Also what is hidden on the map (%1)</source>
        <translation>也包括地图上隐藏的内容（%1）(&amp;A)</translation>
    </message>
    <message>
        <source>Trinary: walls, free and unknown as shown</source>
        <translation>Trinary：墙、空闲和未知，如所显示</translation>
    </message>
    <message>
        <source>Scale: percentages, with a PNG</source>
        <translation>Scale：百分比，用 PNG</translation>
    </message>
    <message>
        <source>Raw: percentages, with a PGM</source>
        <translation>Raw：百分比，用 PGM</translation>
    </message>
    <message>
        <source>Write the probabilities themselves, and let these thresholds decide</source>
        <translation>写出概率本身，由这些阈值判断</translation>
    </message>
    <message>
        <source>occupied above</source>
        <translation>占据：高于</translation>
    </message>
    <message>
        <source>free below</source>
        <translation>空闲：低于</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>What is hidden on the map is left out.</source>
        <translation>地图上隐藏的内容不写入。</translation>
    </message>
    <message>
        <source>Unsaved changes are left out.</source>
        <translation>未保存的更改不写入。</translation>
    </message>
    <message>
        <source>%1 of %2 are included.</source>
        <translation>包含 %1 / %2。</translation>
    </message>
    <message>
        <source>Missing or damaged: %1.</source>
        <translation>缺失或损坏：%1。</translation>
    </message>
    <message>
        <source>ROS maps (*.yaml)</source>
        <translation>ROS 地图 (*.yaml)</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>导出到</translation>
    </message>
    <message>
        <source>%1 Press Export again to write them anyway.</source>
        <translation>%1再按一次“导出”仍会写出。</translation>
    </message>
    <message>
        <source>The map was read from %1. Press Export again to replace the file, or choose another name.</source>
        <translation>地图是从 %1 读取的。再按一次“导出”会替换该文件，或另选名称。</translation>
    </message>
    <message>
        <source>%1 already exists. Press Export again to replace it.</source>
        <translation>%1 已存在。再按一次“导出”会替换它。</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was written.</source>
        <translation>已取消，未写入任何内容。</translation>
    </message>
    <message>
        <source>Parts of this map could not be read. They would be unknown cells.</source>
        <translation>此地图有部分无法读取，导出后将成为未知栅格。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::FilesController</name>
    <message>
        <source>&amp;Open file…</source>
        <translation>打开文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a map.yaml, a picture of a map or a recording from this computer</source>
        <translation>打开这台电脑上的 map.yaml、地图图像或录制文件</translation>
    </message>
    <message>
        <source>Open a map or a recording</source>
        <translation>打开地图或录制文件</translation>
    </message>
    <message>
        <source>%1 does not exist.</source>
        <translation>%1 不存在。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>%1 is neither a map nor a recording. Choose a map.yaml, a picture (PNG, PGM, BMP), overlays (GeoJSON), a state file of Cartographer (.pbstream), an MCAP file or a bag (.bag, .db3).</source>
        <translation>%1 既不是地图也不是录制文件。请选择 map.yaml、图像（PNG、PGM、BMP）、覆盖物 (GeoJSON)、Cartographer 状态文件 (.pbstream)、MCAP 文件或数据包（.bag、.db3）。</translation>
    </message>
    <message>
        <source>Drop to play this recording</source>
        <translation>松开以播放此录制文件</translation>
    </message>
    <message>
        <source>Drop to open this map</source>
        <translation>松开以打开此地图</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::FoldHeader</name>
    <message>
        <source>unfolded</source>
        <translation>已展开</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>已折叠</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::FoundRobots</name>
    <message>
        <source>Robots that answered</source>
        <translation>有应答的机器人</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详情</translation>
    </message>
    <message>
        <source>Which ports were tried, and why no robot was found</source>
        <translation>试过哪些端口，为什么没有找到机器人</translation>
    </message>
    <message>
        <source>Looking at %1: %2 of %3 asked …</source>
        <translation>正在查看 %1：已询问 %2 / %3 …</translation>
    </message>
    <message numerus="yes">
        <source>%1 ways to connect to %2</source>
        <translation>
            <numerusform>%1 种方式可连接到 %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped. Nothing has answered at %1 yet.</source>
        <translation>已停止。%1 尚无应答。</translation>
    </message>
    <message>
        <source>No robot answers at %1. Is it switched on, and in this network?</source>
        <translation>%1 没有机器人应答。它是否已开机并在此网络中？</translation>
    </message>
    <message>
        <source>No robot answers at %1. %2: %3.</source>
        <translation>%1 没有机器人应答。%2：%3。</translation>
    </message>
    <message>
        <source>No robot answers at %1: %2. Is it switched on, and in this network?</source>
        <translation>%1 没有机器人应答：%2。它是否已开机并在此网络中？</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::GoToDialog</name>
    <message>
        <source>Go</source>
        <translation>前往</translation>
    </message>
    <message>
        <source>Go to coordinates</source>
        <translation>转到坐标</translation>
    </message>
    <message>
        <source>&amp;x, y in metres</source>
        <translation>x, y（米）(&amp;X)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Enter two numbers in metres, for example 12.5, -3.2.</source>
        <translation>请输入两个以米为单位的数字，例如 12.5, -3.2。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::GroupForm</name>
    <message>
        <source>Shift along x</source>
        <translation>沿 x 平移</translation>
    </message>
    <message>
        <source>Shift along y</source>
        <translation>沿 y 平移</translation>
    </message>
    <message>
        <source>Heading of all selected</source>
        <translation>所有选中项的朝向</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>New names for all of them: counted, or with a part replaced (F2)</source>
        <translation>为它们全部取新名称：编号，或替换其中一部分 (F2)</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>to</source>
        <translation>转到</translation>
    </message>
    <message>
        <source>by</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>How the heading changes</source>
        <translation>朝向如何改变</translation>
    </message>
    <message>
        <source>add, then Enter</source>
        <translation>添加，按 Enter</translation>
    </message>
    <message>
        <source>Tags to add to all selected</source>
        <translation>为所有选中项添加的标签</translation>
    </message>
    <message>
        <source>remove, then Enter</source>
        <translation>移除，按 Enter</translation>
    </message>
    <message>
        <source>Tags to remove from all selected</source>
        <translation>从所有选中项移除的标签</translation>
    </message>
    <message>
        <source>Kind of all selected</source>
        <translation>所有选中项的类型</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>kind of %1</source>
        <translation>更改 %1 的类型</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>tag %1</source>
        <translation>为 %1 添加标签</translation>
    </message>
    <message>
        <source>untag %1</source>
        <translation>移除 %1 的标签</translation>
    </message>
    <message>
        <source>%1: x %2 m, y %3 m</source>
        <translation>%1：x %2 m，y %3 m</translation>
    </message>
    <message>
        <source>, different headings</source>
        <translation>，朝向不同</translation>
    </message>
    <message>
        <source>, heading %1</source>
        <translation>，朝向 %1</translation>
    </message>
    <message>
        <source>, no heading</source>
        <translation>，无朝向</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1（%2 / %3）</translation>
    </message>
    <message>
        <source>No tags</source>
        <translation>没有标签</translation>
    </message>
    <message>
        <source>different</source>
        <translation>不同</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::HeightSlider</name>
    <message>
        <source>Visible heights</source>
        <translation>可见高度</translation>
    </message>
    <message>
        <source>from %1 m to %2 m</source>
        <translation>从 %1 m 到 %2 m</translation>
    </message>
    <message>
        <source>There are no heights to choose from.</source>
        <translation>没有可选的高度。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::HelpController</name>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>How to do it: tasks, keys and commands, with a search</source>
        <translation>如何操作：任务、按键和命令，可搜索</translation>
    </message>
    <message>
        <source>&amp;Find anything…</source>
        <translation>查找任意内容(&amp;F)…</translation>
    </message>
    <message>
        <source>Search commands, objects, submaps, maps, layers and topics by name</source>
        <translation>按名称搜索命令、对象、子图、地图、图层和话题</translation>
    </message>
    <message>
        <source>&amp;Keys and gestures</source>
        <translation>按键和手势(&amp;K)</translation>
    </message>
    <message>
        <source>All keyboard shortcuts and gestures on one page</source>
        <translation>一页列出全部快捷键和手势</translation>
    </message>
    <message>
        <source>&amp;Diagnostics</source>
        <translation>诊断(&amp;D)</translation>
    </message>
    <message>
        <source>Threads, memory and messages: usage, limits and rates</source>
        <translation>线程、内存和消息：用量、上限和速率</translation>
    </message>
    <message>
        <source>&amp;About mapwright</source>
        <translation>关于 mapwright(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licences</source>
        <translation>版本和许可证</translation>
    </message>
    <message>
        <source>Diagnostics copied</source>
        <translation>诊断已复制</translation>
    </message>
    <message>
        <source>&amp;Copy diagnostics</source>
        <translation>复制诊断信息(&amp;C)</translation>
    </message>
    <message>
        <source>Versions, system, numbers and problems as a text, for people who help.</source>
        <translation>版本、系统、数字和问题，以文本形式提供给协助的人。</translation>
    </message>
    <message>
        <source>Open: %1, %2</source>
        <translation>已打开：%1，%2</translation>
    </message>
    <message>
        <source>Model: %1, version %2</source>
        <translation>型号：%1，版本 %2</translation>
    </message>
    <message>
        <source>Model: %1</source>
        <translation>型号：%1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ImportDialog</name>
    <message>
        <source>new</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>renamed</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>retagged</source>
        <translation>更改标签</translation>
    </message>
    <message>
        <source>of another kind</source>
        <translation>更改类型</translation>
    </message>
    <message>
        <source>deleted</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>First row contains the &amp;column names</source>
        <translation>第一行是列名(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Decimal commas</source>
        <translation>小数逗号(&amp;D)</translation>
    </message>
    <message>
        <source>Delete waypoints that are &amp;not in it</source>
        <translation>删除其中没有的路径点(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>应用(&amp;A)</translation>
    </message>
    <message>
        <source>Paste waypoints</source>
        <translation>粘贴路径点</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>制表符</translation>
    </message>
    <message>
        <source>Commas</source>
        <translation>逗号</translation>
    </message>
    <message>
        <source>Semicolons</source>
        <translation>分号</translation>
    </message>
    <message>
        <source>Column separator</source>
        <translation>列分隔符</translation>
    </message>
    <message>
        <source>Headings as they look</source>
        <translation>朝向：按数值判断</translation>
    </message>
    <message>
        <source>Headings in degrees</source>
        <translation>朝向：度</translation>
    </message>
    <message>
        <source>Headings in radians</source>
        <translation>朝向：弧度</translation>
    </message>
    <message>
        <source>Unit of headings</source>
        <translation>朝向的单位</translation>
    </message>
    <message>
        <source>For headings whose name has no unit: yaw_rad is always in radians</source>
        <translation>用于名称中没有单位的朝向：yaw_rad 始终为弧度</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>改变的内容</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Nothing changes: these waypoints are already here.</source>
        <translation>没有改变：这些路径点已在这里。</translation>
    </message>
    <message>
        <source>%1. Nothing has been sent or saved yet.</source>
        <translation>%1。尚未下发或保存任何内容。</translation>
    </message>
    <message>
        <source>Only the first %1 are shown.</source>
        <translation>只显示前 %1 个。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::InspectorController</name>
    <message>
        <source>Filter &amp;submaps</source>
        <translation>筛选子图(&amp;S)</translation>
    </message>
    <message>
        <source>Go to the filter of the SLAM inspector</source>
        <translation>转到 SLAM 检查器的筛选框</translation>
    </message>
    <message>
        <source>Select submap %1</source>
        <translation>选择子图 %1</translation>
    </message>
    <message>
        <source>Hide submap %1</source>
        <translation>隐藏子图 %1</translation>
    </message>
    <message>
        <source>Submap %1</source>
        <translation>子图 %1</translation>
    </message>
    <message>
        <source>Submap</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Submap %1 has no valid pose, so it cannot be placed on the map.</source>
        <translation>子图 %1 没有有效的位姿，无法放到地图上。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::InspectorDock</name>
    <message>
        <source> (v%1 on screen)</source>
        <translation> （屏幕上为 v%1）</translation>
    </message>
    <message>
        <source>no valid pose</source>
        <translation>没有有效的位姿</translation>
    </message>
    <message numerus="yes">
        <source>%1 slices</source>
        <translation>
            <numerusform>%1 个切片</numerusform>
        </translation>
    </message>
    <message>
        <source>SLAM inspector</source>
        <translation>SLAM 检查器</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>会话</translation>
    </message>
    <message>
        <source>Copy the session&apos;s uuid</source>
        <translation>复制会话的 uuid</translation>
    </message>
    <message>
        <source>Submaps</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>Fetches</source>
        <translation>获取</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>已接收</translation>
    </message>
    <message>
        <source>Session uuid copied</source>
        <translation>会话 uuid 已复制</translation>
    </message>
    <message>
        <source>a file: nothing is being mapped</source>
        <translation>是文件：没有在建图</translation>
    </message>
    <message>
        <source>%1 (as of %2)</source>
        <translation>%1（截至 %2）</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1，分属 %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 trajectories</source>
        <translation>
            <numerusform>%1 条轨迹</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 hidden</source>
        <translation>，%1 个隐藏</translation>
    </message>
    <message>
        <source>%1 of pictures</source>
        <translation>图像 %1</translation>
    </message>
    <message>
        <source>%1 to come, %2 failed</source>
        <translation>待获取 %1，失败 %2</translation>
    </message>
    <message>
        <source>%1 in %2, %3 from disk</source>
        <translation>%1，共 %2，来自磁盘 %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 answers</source>
        <translation>
            <numerusform>%1 个应答</numerusform>
        </translation>
    </message>
    <message>
        <source>Nearby</source>
        <translation>附近</translation>
    </message>
    <message>
        <source>Show or hide the submaps of nearby maps</source>
        <translation>显示或隐藏附近地图的子图</translation>
    </message>
    <message>
        <source>Incremental</source>
        <translation>增量</translation>
    </message>
    <message>
        <source>Show or hide the incremental submaps</source>
        <translation>显示或隐藏增量子图</translation>
    </message>
    <message>
        <source>Filter: 12-3, v70, frozen, failed…</source>
        <translation>筛选：12-3、v70、冻结、失败…</translation>
    </message>
    <message>
        <source>Trajectory and index (12-3), index (592), version (v70), frozen, active, incremental, nearby, hidden,
shown, updating, queued, fetching, missing, failed, corrupt. Separate several terms with spaces: all must match.</source>
        <translation>轨迹和索引 (12-3)、索引 (592)、版本 (v70)、frozen、active、incremental、nearby、hidden、
shown、updating、queued、fetching、missing、failed、corrupt。多个条件用空格分开：须全部符合。</translation>
    </message>
    <message>
        <source>Filter submaps</source>
        <translation>筛选子图</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>活动</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>时间先后</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Colours: Incremental tints incremental submaps, Active dims frozen ones,
the others colour by trajectory, by age and by version (the legend says how)</source>
        <translation>颜色：“增量”为增量子图着色，“活动”使冻结的子图变暗，
其余按轨迹、时间先后和版本着色（见图例）</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Slice </source>
        <translation>切片 </translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>Slice to draw of every submap: 0 to %1</source>
        <translation>每个子图绘制的切片：0 到 %1</translation>
    </message>
    <message>
        <source>Slice to draw of every submap; these have only one</source>
        <translation>每个子图绘制的切片；这些只有一个</translation>
    </message>
    <message>
        <source>Locate on the map</source>
        <translation>在地图上定位</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show only these</source>
        <translation>只显示这些</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>复制详情</translation>
    </message>
    <message>
        <source>Details copied</source>
        <translation>详情已复制</translation>
    </message>
    <message>
        <source>Expand all</source>
        <translation>全部展开</translation>
    </message>
    <message>
        <source>Collapse all</source>
        <translation>全部折叠</translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps are selected.</source>
        <translation>
            <numerusform>已选中 %1 个子图。</numerusform>
        </translation>
    </message>
    <message>
        <source>Select a submap to see its pose and state. Double-click one to show it on the map.</source>
        <translation>选择一个子图以查看其位姿和状态。双击可在地图上显示。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LanguageController</name>
    <message>
        <source>Language of the system</source>
        <translation>系统语言</translation>
    </message>
    <message>
        <source>Language: that of the system</source>
        <translation>语言：跟随系统</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>语言：%1</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>The window is in %1 from the next start of mapwright on.</source>
        <translation>下次启动 mapwright 后，窗口将使用%1。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LayerRow</name>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message>
        <source>Opacity of %1</source>
        <translation>%1 的不透明度</translation>
    </message>
    <message>
        <source>Colour, topic and more</source>
        <translation>颜色、话题等</translation>
    </message>
    <message>
        <source>Colour, size and more</source>
        <translation>颜色、大小等</translation>
    </message>
    <message>
        <source>Settings of %1</source>
        <translation>%1 的设置</translation>
    </message>
    <message>
        <source>Hide this layer. Alt+click: show only this layer</source>
        <translation>隐藏此图层。Alt+单击：只显示此图层</translation>
    </message>
    <message>
        <source>Show this layer. Alt+click: show only this layer</source>
        <translation>显示此图层。Alt+单击：只显示此图层</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LayerStyleEditor</name>
    <message>
        <source>Colour of %1</source>
        <translation>%1 的颜色</translation>
    </message>
    <message>
        <source>Reset to the theme&apos;s colour</source>
        <translation>重置为主题的颜色</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Topic of %1</source>
        <translation>%1 的话题</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>话题</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Default (%1)</source>
        <translation>默认（%1）</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LayersController</name>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>网格(&amp;G)</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>显示网格</translation>
    </message>
    <message>
        <source>Show the metric grid</source>
        <translation>显示米制网格</translation>
    </message>
    <message>
        <source>Submap &amp;ids</source>
        <translation>子图编号(&amp;I)</translation>
    </message>
    <message>
        <source>Show the ids of submaps</source>
        <translation>显示子图编号</translation>
    </message>
    <message>
        <source>Show the ids of the submaps on the map</source>
        <translation>在地图上显示子图编号</translation>
    </message>
    <message>
        <source>Submap &amp;outlines</source>
        <translation>子图轮廓(&amp;O)</translation>
    </message>
    <message>
        <source>Show the outlines of submaps</source>
        <translation>显示子图轮廓</translation>
    </message>
    <message>
        <source>Show the outlines of the submaps on the map</source>
        <translation>在地图上显示子图轮廓</translation>
    </message>
    <message>
        <source>&amp;Submaps</source>
        <translation>子图(&amp;S)</translation>
    </message>
    <message>
        <source>Show the submaps</source>
        <translation>显示子图</translation>
    </message>
    <message>
        <source>&amp;Whole map</source>
        <translation>整张地图(&amp;W)</translation>
    </message>
    <message>
        <source>Show the whole map</source>
        <translation>显示整张地图</translation>
    </message>
    <message>
        <source>&amp;Both</source>
        <translation>两者(&amp;B)</translation>
    </message>
    <message>
        <source>Show the whole map below the submaps</source>
        <translation>在子图下方显示整张地图</translation>
    </message>
    <message>
        <source>Normal colours</source>
        <translation>普通颜色</translation>
    </message>
    <message>
        <source>Plain grey</source>
        <translation>纯灰色</translation>
    </message>
    <message>
        <source>Tint incremental submaps</source>
        <translation>为增量子图着色</translation>
    </message>
    <message>
        <source>Incremental submaps in blue and red</source>
        <translation>增量子图用蓝色和红色</translation>
    </message>
    <message>
        <source>Dim frozen submaps</source>
        <translation>冻结子图变暗</translation>
    </message>
    <message>
        <source>Only active submaps at full strength</source>
        <translation>只有活动子图全色显示</translation>
    </message>
    <message>
        <source>Colour by trajectory</source>
        <translation>按轨迹着色</translation>
    </message>
    <message>
        <source>Each trajectory in a colour of its own</source>
        <translation>每条轨迹一种颜色</translation>
    </message>
    <message>
        <source>Colour by age</source>
        <translation>按时间先后着色</translation>
    </message>
    <message>
        <source>Older and newer submaps of each trajectory</source>
        <translation>每条轨迹中较旧和较新的子图</translation>
    </message>
    <message>
        <source>Colour by version</source>
        <translation>按版本着色</translation>
    </message>
    <message>
        <source>Submaps with few scans and with many</source>
        <translation>激光扫描少的子图和多的子图</translation>
    </message>
    <message>
        <source>Colours as before: %1</source>
        <translation>颜色恢复：%1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LayersDock</name>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>One list in the order of painting, the top layer first, without groups</source>
        <translation>按绘制顺序排成一个列表，最上面的图层在前，不分组</translation>
    </message>
    <message>
        <source>In the order of painting</source>
        <translation>按绘制顺序</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Show all layers that were shown before</source>
        <translation>重新显示此前显示的所有图层</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Filter layers</source>
        <translation>筛选图层</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Sets of layers to choose from; save your own</source>
        <translation>可选的图层组合；也可保存自己的</translation>
    </message>
    <message>
        <source>There is no layer called “%1”.</source>
        <translation>没有叫“%1”的图层。</translation>
    </message>
    <message numerus="yes">
        <source>%1 layers that this file has no data for</source>
        <translation>
            <numerusform>%1 个图层在此文件中没有数据</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 layers that these files have no data for</source>
        <translation>
            <numerusform>%1 个图层在这些文件中没有数据</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 layers that this robot has no data for</source>
        <translation>
            <numerusform>%1 个图层在该机器人上没有数据</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Only: %1</source>
        <translation>仅：%1</translation>
    </message>
    <message>
        <source>Show what was shown before</source>
        <translation>显示此前显示的内容</translation>
    </message>
    <message>
        <source>Show only this layer</source>
        <translation>只显示此图层</translation>
    </message>
    <message>
        <source>Zoom to this layer</source>
        <translation>缩放到此图层</translation>
    </message>
    <message>
        <source>Nothing in this layer has a position</source>
        <translation>此图层中没有内容带有位置</translation>
    </message>
    <message>
        <source>Its content is unknown while it is hidden</source>
        <translation>隐藏时其内容未知</translation>
    </message>
    <message>
        <source>In groups</source>
        <translation>按组</translation>
    </message>
    <message>
        <source>Fold all groups</source>
        <translation>折叠所有组</translation>
    </message>
    <message>
        <source>Unfold all groups</source>
        <translation>展开所有组</translation>
    </message>
    <message>
        <source>Reset order and styles</source>
        <translation>重置顺序和样式</translation>
    </message>
    <message>
        <source>Show the original layers</source>
        <translation>显示原有图层</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LayoutController</name>
    <message>
        <source>&amp;Operate</source>
        <translation>操作(&amp;O)</translation>
    </message>
    <message>
        <source>Layout for waypoints and the robot</source>
        <translation>用于路径点和机器人的布局</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>检查(&amp;I)</translation>
    </message>
    <message>
        <source>Layout for submaps, layers and problems</source>
        <translation>用于子图、图层和问题的布局</translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation>回放(&amp;R)</translation>
    </message>
    <message>
        <source>Layout for recordings: timeline, events, messages and plots</source>
        <translation>用于录制文件的布局：时间轴、事件、消息和曲线图</translation>
    </message>
    <message>
        <source>The layout Replay has the timeline, events, messages and plots side by side.</source>
        <translation>“回放”布局把时间轴、事件、消息和曲线图并排显示。</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>使用它</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LeaveOutController</name>
    <message>
        <source>Leave out submap %1…</source>
        <translation>去掉子图 %1…</translation>
    </message>
    <message>
        <source>Leave out…</source>
        <translation>去掉…</translation>
    </message>
    <message>
        <source>Write a new state file without it. The present one stays as it is.</source>
        <translation>写一个不含它的新状态文件，现有文件保持不变。</translation>
    </message>
    <message>
        <source>The pose graph has not been read yet.</source>
        <translation>尚未读取位姿图。</translation>
    </message>
    <message>
        <source>Only a Cartographer state file (.pbstream) that is open can be written again without something, and this is none. Some robots give theirs: see &quot;Its submaps&quot; in the Maps panel.</source>
        <translation>只有打开的 Cartographer 状态文件 (.pbstream) 才能去掉部分内容后重写，而这里没有打开。有些机器人会提供自己的状态文件：见“地图”面板中的“其子图”。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LeaveOutDialog</name>
    <message>
        <source>The loop closure of submap %1 and node %2</source>
        <translation>子图 %1 与节点 %2 的回环</translation>
    </message>
    <message>
        <source>Only this constraint goes.</source>
        <translation>只去掉这一个约束。</translation>
    </message>
    <message>
        <source>Submap %1</source>
        <translation>子图 %1</translation>
    </message>
    <message>
        <source>All constraints of what goes are left out, too. The scans stay.</source>
        <translation>与去掉内容有关的所有约束也一并去掉，激光扫描保留。</translation>
    </message>
    <message>
        <source>Trajectory %1</source>
        <translation>轨迹 %1</translation>
    </message>
    <message>
        <source>All of it goes: submaps, scans, sensor data, and the constraints from and to it.</source>
        <translation>全部去掉：子图、激光扫描、传感器数据，以及与之相关的约束。</translation>
    </message>
    <message>
        <source>Write the new file</source>
        <translation>写新文件</translation>
    </message>
    <message>
        <source>Open the new file</source>
        <translation>打开新文件</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>去掉</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>浏览(&amp;B)…</translation>
    </message>
    <message>
        <source>New &amp;file</source>
        <translation>新文件(&amp;F)</translation>
    </message>
    <message>
        <source>A new file is written, without what is chosen here. %1 stays as it is.</source>
        <translation>写一个不含此处所选内容的新文件。%1 保持不变。</translation>
    </message>
    <message>
        <source>Reading the file…</source>
        <translation>正在读取文件…</translation>
    </message>
    <message>
        <source>Writing the new file…</source>
        <translation>正在写新文件…</translation>
    </message>
    <message>
        <source>Reading the new file again and comparing it…</source>
        <translation>正在重新读取新文件并比较…</translation>
    </message>
    <message>
        <source>%1 No pose changes: Cartographer optimises them when it loads the new file and runs again.</source>
        <translation>%1位姿都不改变：Cartographer 加载新文件并再次运行时会优化它们。</translation>
    </message>
    <message>
        <source>Write the new file to</source>
        <translation>新文件写到</translation>
    </message>
    <message>
        <source>Cartographer state files (*.pbstream)</source>
        <translation>Cartographer 状态文件 (*.pbstream)</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was written.</source>
        <translation>已取消，未写入任何内容。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LegendDock</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>No visible layer has colours or shapes to explain.</source>
        <translation>没有可见图层含需要说明的颜色或形状。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LineBar</name>
    <message>
        <source>Distance between two waypoints</source>
        <translation>两个路径点之间的距离</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>What their names begin with</source>
        <translation>名称的开头</translation>
    </message>
    <message>
        <source>First number</source>
        <translation>第一个编号</translation>
    </message>
    <message>
        <source>The first number, with as many digits as all shall have: 1, 01, 001. Empty: the next free one</source>
        <translation>第一个编号，位数即所有编号的位数：1、01、001。留空：下一个空号</translation>
    </message>
    <message>
        <source>Step from number to number</source>
        <translation>编号的步长</translation>
    </message>
    <message>
        <source>%1 on 123.45 m</source>
        <translation>123.45 m 上 %1</translation>
    </message>
    <message>
        <source>&amp;Spacing</source>
        <translation>间距(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>fr&amp;om</source>
        <translation>起始(&amp;O)</translation>
    </message>
    <message>
        <source>ste&amp;p</source>
        <translation>步长(&amp;P)</translation>
    </message>
    <message>
        <source>The first number has digits only, at most %1.</source>
        <translation>第一个编号只能是数字，最多 %1。</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>; %1 is taken and left out</source>
        <translation>；%1 已被占用，跳过</translation>
    </message>
    <message numerus="yes">
        <source>; %1 names are taken and left out</source>
        <translation>
            <numerusform>；%1 个名称已被占用，跳过</numerusform>
        </translation>
    </message>
    <message>
        <source>No line yet</source>
        <translation>还没有线</translation>
    </message>
    <message>
        <source>More than %1</source>
        <translation>超过 %1</translation>
    </message>
    <message>
        <source>%1 on %2 m</source>
        <translation>%2 m 上 %1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::LineTool</name>
    <message>
        <source>Waypoints along a line: click its start, or drag. Esc leaves.</source>
        <translation>沿线布置路径点：单击起点，或拖动。Esc 退出。</translation>
    </message>
    <message>
        <source>Click the end. Shift: steps of 15°, Alt: free, Esc starts over.</source>
        <translation>单击终点。Shift：按 15° 步进，Alt：自由，Esc 重新开始。</translation>
    </message>
    <message>
        <source>Enter creates them, Esc starts over.</source>
        <translation>按 Enter 创建，Esc 重新开始。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MainWindow</name>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Quit mapwright</source>
        <translation>退出 mapwright</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>Restore the original docks, layers and colours</source>
        <translation>恢复原有的面板、图层和颜色</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>Search all pages (Ctrl+F)</source>
        <translation>搜索所有页面 (Ctrl+F)</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>手册的页面</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>手册页面</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>搜索手册</translation>
    </message>
    <message>
        <source>%1 is not in this manual.</source>
        <translation>手册中没有 %1。</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>后退 (Alt+Left)</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>前进 (Alt+Right)</translation>
    </message>
    <message>
        <source>No page has these words in one place.</source>
        <translation>没有页面在同一处含有这些词。</translation>
    </message>
    <message>
        <source>%1 places, the first %2 are listed</source>
        <translation>%1 处，列出前 %2 处</translation>
    </message>
    <message numerus="yes">
        <source>%1 places</source>
        <translation>
            <numerusform>%1 处</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MapFetch</name>
    <message>
        <source>Fetching the region: %1 of %2 parts received.</source>
        <translation>正在获取分块：已收到 %1 / %2 部分。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Fetch the whole map</source>
        <translation>获取整张地图</translation>
    </message>
    <message>
        <source>Fetch the whole map at once? %1</source>
        <translation>一次获取整张地图？%1</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>获取</translation>
    </message>
    <message>
        <source>Fetch a region…</source>
        <translation>获取一个分块…</translation>
    </message>
    <message>
        <source>The whole map was not fetched: %1</source>
        <translation>未获取整张地图：%1</translation>
    </message>
    <message>
        <source>Whole map</source>
        <translation>整张地图</translation>
    </message>
    <message>
        <source>fetched %1</source>
        <translation>获取于 %1</translation>
    </message>
    <message>
        <source>%1 is shown. The layer &quot;Map by regions&quot; is hidden.</source>
        <translation>已显示 %1。“分块地图”图层已隐藏。</translation>
    </message>
    <message>
        <source>&quot;Keep on screen&quot; replaces %1, which is not saved.</source>
        <translation>“保留在屏幕上”会替换未保存的 %1。</translation>
    </message>
    <message>
        <source>Fetch a region</source>
        <translation>获取分块</translation>
    </message>
    <message>
        <source>Keep on screen</source>
        <translation>保留在屏幕上</translation>
    </message>
    <message>
        <source>Save as PGM and YAML…</source>
        <translation>保存为 PGM 和 YAML…</translation>
    </message>
    <message>
        <source>This region is too large to be fetched at once: %1</source>
        <translation>此分块太大，无法一次获取：%1</translation>
    </message>
    <message>
        <source>The map is empty in this region.</source>
        <translation>地图在此分块中为空。</translation>
    </message>
    <message>
        <source>The region was not fetched: %1</source>
        <translation>未获取分块：%1</translation>
    </message>
    <message>
        <source>Parts of the region are missing and shown as unknown (%1 of %2 arrived): %3</source>
        <translation>分块的部分内容缺失，显示为未知（已到 %1 / %2）：%3</translation>
    </message>
    <message>
        <source>The robot&apos;s answers are smaller than the requested regions: the missing parts are shown as unknown.</source>
        <translation>机器人的应答比所请求的分块小：缺失部分显示为未知。</translation>
    </message>
    <message>
        <source>Some of the answers have cells of another size or orientation and were left out.</source>
        <translation>有些应答的栅格大小或方向不同，已略去。</translation>
    </message>
    <message>
        <source>Region %1</source>
        <translation>分块 %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>The map is still loading.</source>
        <translation>地图仍在加载。</translation>
    </message>
    <message>
        <source>Save the region</source>
        <translation>保存分块</translation>
    </message>
    <message>
        <source>Maps for map_server (*.yaml)</source>
        <translation>供 map_server 使用的地图 (*.yaml)</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MapView</name>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>放大(&amp;I)</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>缩小(&amp;O)</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Zoom to 1:1</source>
        <translation>缩放到 1:1</translation>
    </message>
    <message>
        <source>One cell of 5 cm on one pixel</source>
        <translation>5 cm 的栅格对应一个像素</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适应窗口(&amp;F)</translation>
    </message>
    <message>
        <source>Fit the map</source>
        <translation>地图适应窗口</translation>
    </message>
    <message>
        <source>Show the whole map</source>
        <translation>显示整张地图</translation>
    </message>
    <message>
        <source>&amp;North up</source>
        <translation>北向上(&amp;N)</translation>
    </message>
    <message>
        <source>Turn the map north up</source>
        <translation>把地图转到北向上</translation>
    </message>
    <message>
        <source>Rotate the view so that the map&apos;s y axis points up</source>
        <translation>旋转视图，使地图的 y 轴朝上</translation>
    </message>
    <message>
        <source>Rotate &amp;left</source>
        <translation>向左旋转(&amp;L)</translation>
    </message>
    <message>
        <source>Rotate the map left</source>
        <translation>向左旋转地图</translation>
    </message>
    <message>
        <source>Rotate the view by 15° counter-clockwise</source>
        <translation>视图逆时针旋转 15°</translation>
    </message>
    <message>
        <source>Rotate r&amp;ight</source>
        <translation>向右旋转(&amp;I)</translation>
    </message>
    <message>
        <source>Rotate the map right</source>
        <translation>向右旋转地图</translation>
    </message>
    <message>
        <source>Rotate the view by 15° clockwise</source>
        <translation>视图顺时针旋转 15°</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MappingDock</name>
    <message>
        <source>The robot is not mapping.</source>
        <translation>机器人没有在建图。</translation>
    </message>
    <message>
        <source>The robot has not said whether it is mapping.</source>
        <translation>机器人没有说明是否在建图。</translation>
    </message>
    <message>
        <source>The robot was mapping when the connection was lost.</source>
        <translation>连接断开时机器人正在建图。</translation>
    </message>
    <message>
        <source>The robot is mapping.</source>
        <translation>机器人正在建图。</translation>
    </message>
    <message>
        <source>The robot is mapping more of %1.</source>
        <translation>机器人正在 %1 上继续建图。</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>建图</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Submaps</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Its map manager is %1.</source>
        <translation>其地图管理器为 %1。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>%1 × %2 m</source>
        <translation>%1 × %2 m</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MapsController</name>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>%1 changed on disk and was read again.</source>
        <translation>%1 在磁盘上有改变，已重新读取。</translation>
    </message>
    <message>
        <source>%1 is not on the robot any more.</source>
        <translation>%1 已不在机器人上。</translation>
    </message>
    <message>
        <source>%1 Its waypoints are shown without it. The robot is in another map and hidden.</source>
        <translation>%1其路径点在没有地图的情况下显示。机器人在另一张地图中，已隐藏。</translation>
    </message>
    <message>
        <source>%1 Its waypoints are shown without it.</source>
        <translation>%1其路径点在没有地图的情况下显示。</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>%1 is not on the robot any more. It stays on screen until you open another map.</source>
        <translation>%1 已不在机器人上。在您打开另一张地图之前，它仍留在屏幕上。</translation>
    </message>
    <message>
        <source>Export it…</source>
        <translation>导出它…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MapsDock</name>
    <message>
        <source>Maps</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Search maps</source>
        <translation>搜索地图</translation>
    </message>
    <message>
        <source>Refresh the list of maps</source>
        <translation>刷新地图列表</translation>
    </message>
    <message>
        <source>Ask the robot for its maps again</source>
        <translation>重新向机器人询问其地图</translation>
    </message>
    <message>
        <source>Asking the robot…</source>
        <translation>正在询问机器人…</translation>
    </message>
    <message>
        <source>%1, as of %2</source>
        <translation>%1，截至 %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 maps</source>
        <translation>
            <numerusform>%1 张地图</numerusform>
        </translation>
    </message>
    <message>
        <source>Connect to a robot to see its maps, or open a map file (Ctrl+Shift+O).</source>
        <translation>连接机器人以查看其地图，或打开地图文件 (Ctrl+Shift+O)。</translation>
    </message>
    <message>
        <source>The robot has no stored maps.</source>
        <translation>机器人没有已存地图。</translation>
    </message>
    <message>
        <source>The list appears as soon as the robot is connected.</source>
        <translation>机器人连接后列表即出现。</translation>
    </message>
    <message>
        <source>No map matches the search.</source>
        <translation>没有符合搜索的地图。</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Show the map by regions again. This changes nothing on the robot.</source>
        <translation>重新显示分块地图。这不改变机器人上的任何内容。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Show it here. This loads and changes nothing on the robot.</source>
        <translation>在这里显示。这不在机器人上加载或改变任何内容。</translation>
    </message>
    <message>
        <source>Compare with the open map</source>
        <translation>与打开的地图比较</translation>
    </message>
    <message>
        <source>Align with the open map</source>
        <translation>与打开的地图对齐</translation>
    </message>
    <message>
        <source>Find out where this map lies on the open one, and lay it under it as the reference map</source>
        <translation>找出此地图在打开的地图上的位置，并作为参考地图铺在其下</translation>
    </message>
    <message>
        <source>Copy id</source>
        <translation>复制编号</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>已复制 %1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MapsModel</name>
    <message>
        <source>Live map</source>
        <translation>实时地图</translation>
    </message>
    <message>
        <source>as the robot sends it</source>
        <translation>按机器人发送的内容</translation>
    </message>
    <message>
        <source>%1, %2 x %3 cells</source>
        <translation>%1，%2 x %3 个栅格</translation>
    </message>
    <message>
        <source>Archived maps</source>
        <translation>已归档的地图</translation>
    </message>
    <message>
        <source>Its submaps</source>
        <translation>其子图</translation>
    </message>
    <message>
        <source>download and open</source>
        <translation>下载并打开</translation>
    </message>
    <message>
        <source>This robot sends no preview of it.</source>
        <translation>该机器人不发送其预览。</translation>
    </message>
    <message>
        <source>%1
%2
Kept until another map is shown. Double-click to preview it.</source>
        <translation>%1
%2
保留到显示另一张地图为止。双击预览。</translation>
    </message>
    <message>
        <source>Double-click to download this map with its data and to open its submaps, trajectories and loop closures.
This changes nothing on the robot.</source>
        <translation>双击下载此地图及其数据，并打开其子图、轨迹和回环。
这不改变机器人上的任何内容。</translation>
    </message>
    <message>
        <source>%1
%2
Double-click to open it.</source>
        <translation>%1
%2
双击打开。</translation>
    </message>
    <message>
        <source>%1
%2
Double-click to open it here. This loads and changes nothing on the robot.</source>
        <translation>%1
%2
双击在这里打开。这不在机器人上加载或改变任何内容。</translation>
    </message>
    <message>
        <source>current</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>open</source>
        <translation>已打开</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MeasureTool</name>
    <message>
        <source>Click where to start measuring. Esc leaves.</source>
        <translation>单击测量的起点。Esc 退出。</translation>
    </message>
    <message>
        <source>Area %1, around it %2. Click to start a new measurement, Esc leaves.</source>
        <translation>面积 %1，周长 %2。单击开始新的测量，Esc 退出。</translation>
    </message>
    <message>
        <source>Total %1. Click to start a new measurement, Esc leaves.</source>
        <translation>总长 %1。单击开始新的测量，Esc 退出。</translation>
    </message>
    <message>
        <source>Total %1. Backspace removes the last point, Esc ends.</source>
        <translation>总长 %1。Backspace 移除最后一点，Esc 结束。</translation>
    </message>
    <message>
        <source>Click to close the ring and see its area.</source>
        <translation>单击以闭合并查看面积。</translation>
    </message>
    <message>
        <source>%1, heading %2. Click to add a point, Esc leaves.</source>
        <translation>%1，朝向 %2。单击添加点，Esc 退出。</translation>
    </message>
    <message>
        <source>%1, heading %2, total %3. Backspace removes the last point, Esc ends.</source>
        <translation>%1，朝向 %2，总长 %3。Backspace 移除最后一点，Esc 结束。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MessageView</name>
    <message>
        <source>Plot %1</source>
        <translation>绘制 %1 的曲线</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MessagesController</name>
    <message>
        <source>Topic</source>
        <translation>话题</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MessagesDock</name>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Listen</source>
        <translation>监听</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Last message</source>
        <translation>最后一条消息</translation>
    </message>
    <message>
        <source>Filter topics</source>
        <translation>筛选话题</translation>
    </message>
    <message>
        <source>/topic to subscribe to</source>
        <translation>要订阅的 /topic</translation>
    </message>
    <message>
        <source>Topic to subscribe to</source>
        <translation>要订阅的话题</translation>
    </message>
    <message>
        <source>Subscribe to this topic while this panel is open</source>
        <translation>此面板打开时订阅此话题</translation>
    </message>
    <message>
        <source>Freeze the display; nothing is received meanwhile</source>
        <translation>冻结显示；期间不接收任何内容</translation>
    </message>
    <message>
        <source>Copy the message as it was received</source>
        <translation>按收到的原样复制消息</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Message copied</source>
        <translation>消息已复制</translation>
    </message>
    <message>
        <source>Message copied as shown, shortened</source>
        <translation>消息已按显示内容复制，有删减</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>话题</translation>
    </message>
    <message>
        <source>Connect to a robot to see its messages.</source>
        <translation>连接机器人以查看其消息。</translation>
    </message>
    <message>
        <source>Nothing has arrived on %1 yet.</source>
        <translation>%1 上尚未收到内容。</translation>
    </message>
    <message>
        <source>Choose a topic to see its last message.</source>
        <translation>选择一个话题以查看其最后一条消息。</translation>
    </message>
    <message>
        <source>, truncated</source>
        <translation>，已截断</translation>
    </message>
    <message>
        <source>, long lists shortened</source>
        <translation>，长列表已缩短</translation>
    </message>
    <message>
        <source>Copy topic</source>
        <translation>复制话题</translation>
    </message>
    <message>
        <source>Topic copied</source>
        <translation>话题已复制</translation>
    </message>
    <message>
        <source>Unsubscribe from it</source>
        <translation>取消订阅</translation>
    </message>
    <message>
        <source>%1  %2, %3%4</source>
        <translation>%1  %2，%3%4</translation>
    </message>
    <message>
        <source>Only %1 topics are listed. Messages of others have come, too.</source>
        <translation>只列出 %1 个话题，也收到了其他话题的消息。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::MirrorTool</name>
    <message>
        <source>mirror %1</source>
        <translation>镜像 %1</translation>
    </message>
    <message>
        <source>Select waypoints first. Esc leaves.</source>
        <translation>请先选择路径点。Esc 退出。</translation>
    </message>
    <message>
        <source>Click a second point of the mirror line. Shift: steps of 15°, Esc starts over.</source>
        <translation>单击镜像线上的第二点。Shift：按 15° 步进，Esc 重新开始。</translation>
    </message>
    <message>
        <source>Mirror %1: click a point of the mirror line, or drag along it. Esc leaves.</source>
        <translation>镜像 %1：单击镜像线上的一点，或沿线拖动。Esc 退出。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::NameEditor</name>
    <message>
        <source>Name of the waypoint</source>
        <translation>路径点的名称</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::NewMapDialog</name>
    <message>
        <source>Add to the robot</source>
        <translation>添加到机器人</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>A map from a picture</source>
        <translation>由图像生成地图</translation>
    </message>
    <message>
        <source> m per pixel</source>
        <translation> m/像素</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>x of the lower left corner</source>
        <translation>左下角的 x</translation>
    </message>
    <message>
        <source>y of the lower left corner</source>
        <translation>左下角的 y</translation>
    </message>
    <message>
        <source>Black pixels are occupied, white ones free, gray and transparent ones unknown (sent as gray). A map made from a picture has no positioning data: the robot may not find its position on it.</source>
        <translation>黑色像素为占据，白色为空闲，灰色和透明为未知（以灰色下发）。由图像生成的地图没有定位数据：机器人可能无法在其上找到自己的位置。</translation>
    </message>
    <message>
        <source>Dashed: what is on screen now. Cross: the origin. Dot: the robot.</source>
        <translation>虚线：屏幕上现有的内容。十字：原点。圆点：机器人。</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation>分辨率(&amp;R)</translation>
    </message>
    <message>
        <source>Lower left corner, &amp;x</source>
        <translation>左下角，x(&amp;X)</translation>
    </message>
    <message>
        <source>Lower left corner, &amp;y</source>
        <translation>左下角，y(&amp;Y)</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>%1 x %2 pixels, %3 x %4 m</source>
        <translation>%1 x %2 像素，%3 x %4 m</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::NewWaypointDialog</name>
    <message>
        <source>New waypoint</source>
        <translation>新路径点</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Counter-clockwise from the x axis of the map</source>
        <translation>从地图 x 轴起逆时针</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;x</source>
        <translation>&amp;x</translation>
    </message>
    <message>
        <source>&amp;y</source>
        <translation>&amp;y</translation>
    </message>
    <message>
        <source>&amp;Heading</source>
        <translation>朝向(&amp;H)</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::NorthArrow</name>
    <message>
        <source>North up</source>
        <translation>北向上</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::NoticeBar</name>
    <message>
        <source>Dismiss</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Dismiss this notice</source>
        <translation>关闭此通知</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ObjectCard</name>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy everything that is known about it</source>
        <translation>复制所有已知信息</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Show everything that is known about it in a panel</source>
        <translation>在面板中显示所有已知信息</translation>
    </message>
    <message>
        <source>Show what lies beneath (Alt+click)</source>
        <translation>显示下面的内容（Alt+单击）</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>关闭 (Esc)</translation>
    </message>
    <message>
        <source>What is this?</source>
        <translation>这是什么？</translation>
    </message>
    <message numerus="yes">
        <source>%1 other things here: Alt+click</source>
        <translation>
            <numerusform>这里还有 %1 个：Alt+单击</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 more in the properties</source>
        <translation>属性中还有 %1 项</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ObjectsController</name>
    <message>
        <source>&amp;What is this?</source>
        <translation>这是什么？(&amp;W)</translation>
    </message>
    <message>
        <source>Show what is under the cursor; again for what lies beneath it</source>
        <translation>显示光标下的内容；再按一次显示其下面的内容</translation>
    </message>
    <message>
        <source>P&amp;roperties of the map</source>
        <translation>地图的属性(&amp;R)</translation>
    </message>
    <message>
        <source>Name, size, resolution, origin and cells of the whole map</source>
        <translation>整张地图的名称、大小、分辨率、原点和栅格</translation>
    </message>
    <message>
        <source>Find an &amp;object…</source>
        <translation>查找对象(&amp;O)…</translation>
    </message>
    <message>
        <source>Search everything that the visible layers show</source>
        <translation>搜索可见图层显示的所有内容</translation>
    </message>
    <message>
        <source>There is no whole map on screen.</source>
        <translation>屏幕上没有整张地图。</translation>
    </message>
    <message>
        <source>It is no longer on the map.</source>
        <translation>它已不在地图上。</translation>
    </message>
    <message>
        <source>Properties copied</source>
        <translation>属性已复制</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ObjectsDock</name>
    <message>
        <source>Objects</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Search by name, kind or layer</source>
        <translation>按名称、类型或图层搜索</translation>
    </message>
    <message>
        <source>Search objects</source>
        <translation>搜索对象</translation>
    </message>
    <message>
        <source>The visible layers show nothing here.</source>
        <translation>可见图层在这里没有显示内容。</translation>
    </message>
    <message numerus="yes">
        <source>%1 objects</source>
        <translation>
            <numerusform>%1 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 objects</source>
        <translation>%1 / %2 个对象</translation>
    </message>
    <message>
        <source>; more are on the map than are listed here</source>
        <translation>；地图上还有更多未列出</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ObjectsModel</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OpacitySlider</name>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayActions</name>
    <message>
        <source>O&amp;verlays</source>
        <translation>覆盖物(&amp;V)</translation>
    </message>
    <message>
        <source>Snap t&amp;o</source>
        <translation>吸附到(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Defaults of the map…</source>
        <translation>地图的默认值(&amp;D)…</translation>
    </message>
    <message>
        <source>The sizes of racks and pallets that are usual on this map</source>
        <translation>此地图上通用的货架和托盘尺寸</translation>
    </message>
    <message>
        <source>&amp;Snap overlays</source>
        <translation>吸附覆盖物(&amp;S)</translation>
    </message>
    <message>
        <source>What is drawn or dragged snaps to what is selected in its menu; Alt suspends it</source>
        <translation>绘制或拖动的内容会吸附到其菜单中所选的对象；按住 Alt 暂停吸附</translation>
    </message>
    <message>
        <source>&amp;Points of overlays</source>
        <translation>覆盖物的点(&amp;P)</translation>
    </message>
    <message>
        <source>Points, ends and corners of other overlays</source>
        <translation>其他覆盖物的点、端点和顶点</translation>
    </message>
    <message>
        <source>&amp;Edges of overlays</source>
        <translation>覆盖物的边(&amp;E)</translation>
    </message>
    <message>
        <source>Lines and outlines of other overlays</source>
        <translation>其他覆盖物的线和轮廓</translation>
    </message>
    <message>
        <source>&amp;Angles of 15° for overlays</source>
        <translation>覆盖物的 15° 角(&amp;A)</translation>
    </message>
    <message>
        <source>From the point before, while a line is drawn</source>
        <translation>画线时，从前一点起算</translation>
    </message>
    <message>
        <source>&amp;Grid for overlays</source>
        <translation>覆盖物的网格(&amp;G)</translation>
    </message>
    <message>
        <source>Lines at a regular distance, see Spacing</source>
        <translation>等距的线，见“间距”</translation>
    </message>
    <message>
        <source>&amp;Walls of the map below</source>
        <translation>下方地图的墙(&amp;W)</translation>
    </message>
    <message>
        <source>The edges of what is occupied on the map</source>
        <translation>地图上占据部分的边缘</translation>
    </message>
    <message>
        <source>&amp;Spacing of the grid for overlays…</source>
        <translation>覆盖物网格的间距(&amp;S)…</translation>
    </message>
    <message>
        <source>The distance between the lines that overlays snap to</source>
        <translation>覆盖物所吸附的线之间的距离</translation>
    </message>
    <message>
        <source>Spacing of the grid</source>
        <translation>网格间距</translation>
    </message>
    <message>
        <source>Metres between its lines</source>
        <translation>线间距（米）</translation>
    </message>
    <message>
        <source>change the defaults of the map</source>
        <translation>更改地图的默认值</translation>
    </message>
    <message>
        <source>Open the overlays of a map first.</source>
        <translation>请先打开一张地图的覆盖物。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayArranging</name>
    <message>
        <source>&amp;Arrange</source>
        <translation>排列(&amp;A)</translation>
    </message>
    <message>
        <source>distribute %1</source>
        <translation>均匀分布 %1</translation>
    </message>
    <message>
        <source>align %1</source>
        <translation>对齐 %1</translation>
    </message>
    <message>
        <source>Align &amp;left edges of overlays</source>
        <translation>覆盖物左对齐(&amp;L)</translation>
    </message>
    <message>
        <source>Along the x axis, to the smallest x of the selection</source>
        <translation>沿 x 轴，对齐到选中项中最小的 x</translation>
    </message>
    <message>
        <source>Align &amp;centres of overlays in x</source>
        <translation>覆盖物按 x 居中对齐(&amp;C)</translation>
    </message>
    <message>
        <source>One above the other</source>
        <translation>上下排列</translation>
    </message>
    <message>
        <source>Align &amp;right edges of overlays</source>
        <translation>覆盖物右对齐(&amp;R)</translation>
    </message>
    <message>
        <source>To the largest x of the selection</source>
        <translation>对齐到选中项中最大的 x</translation>
    </message>
    <message>
        <source>Align &amp;top edges of overlays</source>
        <translation>覆盖物顶端对齐(&amp;T)</translation>
    </message>
    <message>
        <source>To the largest y of the selection</source>
        <translation>对齐到选中项中最大的 y</translation>
    </message>
    <message>
        <source>Align centres of overlays in &amp;y</source>
        <translation>覆盖物按 y 居中对齐(&amp;Y)</translation>
    </message>
    <message>
        <source>One beside the other</source>
        <translation>左右排列</translation>
    </message>
    <message>
        <source>Align &amp;bottom edges of overlays</source>
        <translation>覆盖物底端对齐(&amp;B)</translation>
    </message>
    <message>
        <source>To the smallest y of the selection</source>
        <translation>对齐到选中项中最小的 y</translation>
    </message>
    <message>
        <source>Equal &amp;gaps of overlays in x</source>
        <translation>覆盖物 x 方向等间隔(&amp;G)</translation>
    </message>
    <message>
        <source>The outermost two stay</source>
        <translation>最外侧的两个不动</translation>
    </message>
    <message>
        <source>Equal gaps of overlays in y</source>
        <translation>覆盖物 y 方向等间隔</translation>
    </message>
    <message>
        <source>Select two overlays at least.</source>
        <translation>请至少选择两个覆盖物。</translation>
    </message>
    <message>
        <source>Select three overlays at least.</source>
        <translation>请至少选择三个覆盖物。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayCarrying</name>
    <message>
        <source>The overlays of the reference map cannot be read. %1</source>
        <translation>无法读取参考地图的覆盖物。%1</translation>
    </message>
    <message>
        <source>Carry over overlays</source>
        <translation>迁移覆盖物</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>覆盖物</translation>
    </message>
    <message>
        <source>What becomes of the overlays</source>
        <translation>覆盖物会变成什么</translation>
    </message>
    <message>
        <source>It is among the overlays of the map on screen now.</source>
        <translation>它现已在屏幕上地图的覆盖物中。</translation>
    </message>
    <message>
        <source>The map on screen has it already, and it stays as it is there.</source>
        <translation>屏幕上的地图已有它，在那里保持不变。</translation>
    </message>
    <message>
        <source>Looking at the walls around each overlay…</source>
        <translation>正在查看每个覆盖物周围的墙…</translation>
    </message>
    <message>
        <source>Lay the old map under this one as a reference map, and align it. Then press Carry over overlays… there.</source>
        <translation>把旧地图作为参考地图铺在这张地图下并对齐，然后在那里按“迁移覆盖物…”。</translation>
    </message>
    <message>
        <source>The reference map has no overlays.</source>
        <translation>参考地图没有覆盖物。</translation>
    </message>
    <message>
        <source>Left out, because coordinates cannot be used: %1.</source>
        <translation>已略过，因为坐标不可用：%1。</translation>
    </message>
    <message>
        <source>carry over %1</source>
        <translation>迁移 %1</translation>
    </message>
    <message>
        <source>%1 carried over. Nothing has been sent or saved yet.</source>
        <translation>已迁移 %1。尚未下发或保存任何内容。</translation>
    </message>
    <message>
        <source>Boxes (bbox) left out because they did not fit their overlay: %1.</source>
        <translation>以下边界框 (bbox) 与其覆盖物不符，已略去：%1。</translation>
    </message>
    <message>
        <source>The box (bbox) of all overlays did not fit them before, and stays as it is.</source>
        <translation>全部覆盖物的边界框 (bbox) 原先就与它们不符，保持原样。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayDraw</name>
    <message>
        <source>A line needs two points.</source>
        <translation>线需要两个点。</translation>
    </message>
    <message>
        <source>A region needs three points that enclose an area.</source>
        <translation>区域需要三个围成面积的点。</translation>
    </message>
    <message>
        <source>Click to add a point. Esc goes back to selecting.</source>
        <translation>单击添加点。Esc 返回选择。</translation>
    </message>
    <message>
        <source>Click where the line begins. Esc goes back to selecting.</source>
        <translation>单击线的起点。Esc 返回选择。</translation>
    </message>
    <message>
        <source>Click where the outline begins. Esc goes back to selecting.</source>
        <translation>单击轮廓的起点。Esc 返回选择。</translation>
    </message>
    <message>
        <source>%1 m. </source>
        <translation>%1 m。</translation>
    </message>
    <message>
        <source>Click to add points; Enter or a double click ends, Backspace removes the last, Esc cancels.</source>
        <translation>单击添加点；Enter 或双击结束，Backspace 移除最后一点，Esc 取消。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayDrawCircle</name>
    <message>
        <source>A circle needs a radius: drag from its centre.</source>
        <translation>圆需要半径：从圆心拖动。</translation>
    </message>
    <message>
        <source>Click where the centre is, or set another radius in the panel. Esc goes back to selecting.</source>
        <translation>单击圆心位置，或在面板中设置其他半径。Esc 返回选择。</translation>
    </message>
    <message>
        <source>Drag a circle from its centre. Esc goes back to selecting.</source>
        <translation>从圆心拖出一个圆。Esc 返回选择。</translation>
    </message>
    <message>
        <source>Radius %1 m. </source>
        <translation>半径 %1 m。</translation>
    </message>
    <message>
        <source>Esc cancels.</source>
        <translation>Esc 取消。</translation>
    </message>
    <message>
        <source>Click where the circle ends. Esc cancels.</source>
        <translation>单击圆的边缘位置。Esc 取消。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayDrawRectangle</name>
    <message>
        <source>Drag a rectangle. Esc goes back to selecting.</source>
        <translation>拖出一个矩形。Esc 返回选择。</translation>
    </message>
    <message>
        <source>Click the opposite corner. Esc cancels.</source>
        <translation>单击对角。Esc 取消。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayFlaws</name>
    <message>
        <source>Ids that occur twice</source>
        <translation>编号重复</translation>
    </message>
    <message>
        <source>Names that occur twice</source>
        <translation>名称重复</translation>
    </message>
    <message>
        <source>Outlines that cross themselves</source>
        <translation>轮廓自交</translation>
    </message>
    <message>
        <source>Outlines without an area</source>
        <translation>轮廓没有面积</translation>
    </message>
    <message>
        <source>Too few points</source>
        <translation>点太少</translation>
    </message>
    <message>
        <source>Outside the map</source>
        <translation>在地图之外</translation>
    </message>
    <message>
        <source>Points in a wall</source>
        <translation>点在墙内</translation>
    </message>
    <message>
        <source>Chargers without a docking point</source>
        <translation>充电桩没有对接点</translation>
    </message>
    <message>
        <source>Doors without a MAC address</source>
        <translation>门没有 MAC 地址</translation>
    </message>
    <message>
        <source>Unusable numbers</source>
        <translation>数字不可用</translation>
    </message>
    <message>
        <source>Points that the robot cannot reach</source>
        <translation>机器人无法到达的点</translation>
    </message>
    <message>
        <source>Radius of the robot</source>
        <translation>机器人半径</translation>
    </message>
    <message>
        <source>What is wrong with the overlays</source>
        <translation>覆盖物有什么问题</translation>
    </message>
    <message>
        <source>Click one to see it on the map</source>
        <translation>单击一个可在地图上查看</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>规则</translation>
    </message>
    <message>
        <source>What is looked for</source>
        <translation>检查哪些内容</translation>
    </message>
    <message>
        <source>Radius of the robot: 0 is that of its own footprint</source>
        <translation>机器人半径：0 表示按其自身外形</translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>还有 %1 个未列出。</numerusform>
        </translation>
    </message>
    <message>
        <source>Robot: %1 m</source>
        <translation>机器人：%1 m</translation>
    </message>
    <message>
        <source>What cannot be read</source>
        <translation>无法读取的内容</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayForm</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Heading of the overlay</source>
        <translation>覆盖物的朝向</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add this property</source>
        <translation>添加此属性</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the selected property</source>
        <translation>移除选中的属性</translation>
    </message>
    <message>
        <source>Name of the overlay</source>
        <translation>覆盖物的名称</translation>
    </message>
    <message>
        <source>Type of the overlay</source>
        <translation>覆盖物的类型</translation>
    </message>
    <message>
        <source>Counter-clockwise from the x axis of the map</source>
        <translation>从地图 x 轴起逆时针</translation>
    </message>
    <message>
        <source>New property</source>
        <translation>新属性</translation>
    </message>
    <message>
        <source>Name of the new property</source>
        <translation>新属性的名称</translation>
    </message>
    <message>
        <source>Properties of the overlay</source>
        <translation>覆盖物的属性</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Value (JSON)</source>
        <translation>值 (JSON)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>change the type of %1</source>
        <translation>更改 %1 的类型</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>several values</source>
        <translation>多个值</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>没有选中任何内容。</translation>
    </message>
    <message>
        <source>%1 selected.</source>
        <translation>已选中 %1。</translation>
    </message>
    <message>
        <source>Id %1</source>
        <translation>编号 %1</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>This is not JSON: %1. Texts stand in quotes.</source>
        <translation>这不是 JSON：%1。文本要加引号。</translation>
    </message>
    <message>
        <source>set %1 of %2</source>
        <translation>设置 %2 的 %1</translation>
    </message>
    <message>
        <source>There is a property %1 already.</source>
        <translation>已有属性 %1。</translation>
    </message>
    <message>
        <source>remove %1 of %2</source>
        <translation>移除 %2 的 %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>还有 %1 个未列出。</numerusform>
        </translation>
    </message>
    <message>
        <source>Only the first %1 properties are compared.</source>
        <translation>只比较前 %1 个属性。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayHistoryDock</name>
    <message>
        <source>Only how it is written</source>
        <translation>只是写法不同</translation>
    </message>
    <message>
        <source>%1: %2; …</source>
        <translation>%1：%2；…</translation>
    </message>
    <message>
        <source>Overlay history</source>
        <translation>覆盖物历史</translation>
    </message>
    <message>
        <source>Restore this version</source>
        <translation>恢复此版本</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Writes this version to a GeoJSON file</source>
        <translation>把此版本写入 GeoJSON 文件</translation>
    </message>
    <message>
        <source>Map whose versions are listed</source>
        <translation>列出哪张地图的版本</translation>
    </message>
    <message>
        <source>Map and robot whose versions are listed</source>
        <translation>列出哪张地图和哪台机器人的版本</translation>
    </message>
    <message>
        <source>Compare the selected version with</source>
        <translation>将选中的版本与之比较</translation>
    </message>
    <message>
        <source>Compared with the version before</source>
        <translation>与前一版本比较</translation>
    </message>
    <message>
        <source>Compared with what is open</source>
        <translation>与打开的内容比较</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Kept when</source>
        <translation>保留时机</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>改变的内容</translation>
    </message>
    <message>
        <source>Versions of the overlays</source>
        <translation>覆盖物的版本</translation>
    </message>
    <message>
        <source>Select two with Ctrl to compare them</source>
        <translation>按住 Ctrl 选择两个进行比较</translation>
    </message>
    <message>
        <source>saved here</source>
        <translation>在这里保存</translation>
    </message>
    <message>
        <source>What the two versions differ in</source>
        <translation>两个版本的差别</translation>
    </message>
    <message>
        <source>Click one to see it on the map</source>
        <translation>单击一个可在地图上查看</translation>
    </message>
    <message>
        <source>read</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>No version of these overlays is kept here yet. Each one that is read or saved will be.</source>
        <translation>这里还没有保留这些覆盖物的版本。每个读取或保存的版本都会保留。</translation>
    </message>
    <message>
        <source>It cannot be read. %1</source>
        <translation>无法读取。%1</translation>
    </message>
    <message>
        <source>First version stored here: %1</source>
        <translation>这里存储的第一个版本：%1</translation>
    </message>
    <message>
        <source>The version before it cannot be read.</source>
        <translation>无法读取它的前一版本。</translation>
    </message>
    <message>
        <source>version %1 of %2</source>
        <translation>版本 %1 / %2</translation>
    </message>
    <message>
        <source>No overlays are open.</source>
        <translation>没有打开的覆盖物。</translation>
    </message>
    <message>
        <source>There is no version before it.</source>
        <translation>它没有前一版本。</translation>
    </message>
    <message>
        <source>What bringing back %1 changes:</source>
        <translation>恢复 %1 会改变：</translation>
    </message>
    <message>
        <source>From %1 to %2:</source>
        <translation>从 %1 到 %2：</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>没有差异。</translation>
    </message>
    <message>
        <source>Select one version first</source>
        <translation>请先选择一个版本</translation>
    </message>
    <message>
        <source>Open the overlays of this map first; without its robot, save the version as a file</source>
        <translation>请先打开此地图的覆盖物；没有其机器人时，可把该版本保存为文件</translation>
    </message>
    <message>
        <source>Another map is open</source>
        <translation>打开的是另一张地图</translation>
    </message>
    <message>
        <source>They cannot be edited at present</source>
        <translation>它们目前不能编辑</translation>
    </message>
    <message>
        <source>Makes the open overlays what they were then: one step that can be undone. Nothing is sent before the review</source>
        <translation>使打开的覆盖物恢复到当时的样子：只是一步，可以撤销。核对之前不会下发</translation>
    </message>
    <message>
        <source>The newest version is not kept here. %1</source>
        <translation>最新版本没有保留在这里。%1</translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>还有 %1 个未列出。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 are not marked on the map.</source>
        <translation>
            <numerusform>%1 个未标在地图上。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayMarksDialog</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Landmarks and barcodes</source>
        <translation>路标和条码</translation>
    </message>
    <message>
        <source>What the robot has collected</source>
        <translation>机器人收集到的内容</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Landmark %1</source>
        <translation>路标 %1</translation>
    </message>
    <message>
        <source>Barcode %1</source>
        <translation>条码 %1</translation>
    </message>
    <message>
        <source>there already, %1 m away: moves it</source>
        <translation>已有，相距 %1 m：移动它</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>There is nothing new: what the robot has collected is in the overlays already, in its place.</source>
        <translation>没有新内容：机器人收集到的都已在覆盖物中，位置也相同。</translation>
    </message>
    <message>
        <source>Robots find their place by these once they are in the overlays. Nothing is sent before you save.</source>
        <translation>加入覆盖物后，机器人靠它们找到自己的位置。保存之前不会下发。</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>采用</translation>
    </message>
    <message numerus="yes">
        <source>Take over %1 marks</source>
        <translation>
            <numerusform>采用 %1 个标记</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayPoints</name>
    <message>
        <source>Points of the overlay</source>
        <translation>覆盖物的点</translation>
    </message>
    <message>
        <source>x m</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y m</source>
        <translation>y (m)</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>没有选中任何内容。</translation>
    </message>
    <message>
        <source>Its points cannot be edited here, only moved as a whole.</source>
        <translation>它的点不能在这里编辑，只能整体移动。</translation>
    </message>
    <message>
        <source>reshape %1</source>
        <translation>改变 %1 的形状</translation>
    </message>
    <message>
        <source>%1 of %2 points are shown.</source>
        <translation>显示了 %2 个点中的 %1 个。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayReview</name>
    <message>
        <source>Save the file</source>
        <translation>保存文件</translation>
    </message>
    <message>
        <source>Save to the robot</source>
        <translation>保存到机器人</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save overlays</source>
        <translation>保存覆盖物</translation>
    </message>
    <message>
        <source>%1 to the overlays of %2. Everything else in the file stays as it is.</source>
        <translation>对 %2 的覆盖物：%1。文件中其余内容保持不变。</translation>
    </message>
    <message>
        <source>%1 to %2 on the robot %3. The robot drives by them from then on; everything else stays as it is.</source>
        <translation>对机器人 %3 上的 %2：%1。此后机器人按它们行驶；其余内容保持不变。</translation>
    </message>
    <message>
        <source>Changes that are saved</source>
        <translation>要保存的更改</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlaySelect</name>
    <message>
        <source>move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>reshape %1</source>
        <translation>改变 %1 的形状</translation>
    </message>
    <message>
        <source>A line needs two points.</source>
        <translation>线需要两个点。</translation>
    </message>
    <message>
        <source>The last point stays: delete the overlay instead.</source>
        <translation>最后一个点不能移除：请改为删除覆盖物。</translation>
    </message>
    <message>
        <source>An outline needs three points.</source>
        <translation>轮廓需要三个点。</translation>
    </message>
    <message>
        <source>%1 in the frame. Esc cancels.</source>
        <translation>框内有 %1。Esc 取消。</translation>
    </message>
    <message>
        <source>Moved by %1, %2 m. Esc cancels.</source>
        <translation>已移动 %1，%2 m。Esc 取消。</translation>
    </message>
    <message>
        <source>Shift turns by 15°, Esc cancels.</source>
        <translation>按住 Shift 以 15° 步进旋转，Esc 取消。</translation>
    </message>
    <message>
        <source>%1, %2 m. Esc cancels.</source>
        <translation>%1，%2 m。Esc 取消。</translation>
    </message>
    <message>
        <source>Drag the point or use the arrows to move it, Delete deletes it. Esc deselects it.</source>
        <translation>拖动该点或用方向键移动，Delete 删除。Esc 取消选择。</translation>
    </message>
    <message>
        <source>Click an overlay to select it, drag to move it, Shift and drag to select several. Esc leaves.</source>
        <translation>单击覆盖物以选择，拖动以移动，按住 Shift 拖动可选择多个。Esc 退出。</translation>
    </message>
    <message>
        <source>%1: drag or use the arrows to move, drag the round handle to turn, Delete deletes. Esc deselects.</source>
        <translation>%1：拖动或用方向键移动，拖动圆形手柄旋转，Delete 删除。Esc 取消选择。</translation>
    </message>
    <message>
        <source>It has %1 points: too many to drag one by one.</source>
        <translation>它有 %1 个点，太多而无法逐个拖动。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlaySnapping</name>
    <message>
        <source>Snapped to %1 (Alt: not). </source>
        <translation>已吸附到%1（Alt：不吸附）。</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>边</translation>
    </message>
    <message>
        <source>a wall of the map</source>
        <translation>地图的墙</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>the grid</source>
        <translation>网格</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayTeaching</name>
    <message>
        <source>From the &amp;robot</source>
        <translation>从机器人(&amp;R)</translation>
    </message>
    <message>
        <source>Add the robot&apos;s &amp;place</source>
        <translation>添加机器人所在位置(&amp;P)</translation>
    </message>
    <message>
        <source>The next point of what is drawn, or a new point, where the robot stands</source>
        <translation>所画内容的下一点，或机器人所在处的新点</translation>
    </message>
    <message>
        <source>&amp;Charger that the robot sees</source>
        <translation>机器人看到的充电桩(&amp;C)</translation>
    </message>
    <message>
        <source>charger</source>
        <translation>充电桩</translation>
    </message>
    <message>
        <source>&amp;Rack that the robot sees, front edge</source>
        <translation>机器人看到的货架，前沿(&amp;R)</translation>
    </message>
    <message>
        <source>rack point</source>
        <translation>货架点</translation>
    </message>
    <message>
        <source>Rack that the robot sees, r&amp;ear edge</source>
        <translation>机器人看到的货架，后沿(&amp;E)</translation>
    </message>
    <message>
        <source>Pa&amp;llet that the robot sees</source>
        <translation>机器人看到的托盘(&amp;L)</translation>
    </message>
    <message>
        <source>pallet</source>
        <translation>托盘</translation>
    </message>
    <message>
        <source>&amp;Trailer that the robot sees</source>
        <translation>机器人看到的拖车(&amp;T)</translation>
    </message>
    <message>
        <source>trailer</source>
        <translation>拖车</translation>
    </message>
    <message>
        <source>Add landmar&amp;ks and barcodes…</source>
        <translation>添加路标和条码(&amp;K)…</translation>
    </message>
    <message>
        <source>Add landmarks and barcodes that the robot has collected</source>
        <translation>添加机器人收集到的路标和条码</translation>
    </message>
    <message>
        <source>Add it as an overlay where the robot sees it, or move the selected one there</source>
        <translation>在机器人看到它的地方添加为覆盖物，或把选中的移到那里</translation>
    </message>
    <message>
        <source>Open the overlays of a map first.</source>
        <translation>请先打开一张地图的覆盖物。</translation>
    </message>
    <message>
        <source>The overlays are being saved.</source>
        <translation>正在保存覆盖物。</translation>
    </message>
    <message>
        <source>The robot is not in this map.</source>
        <translation>机器人不在此地图中。</translation>
    </message>
    <message>
        <source>The position of the robot is unknown.</source>
        <translation>机器人的位置未知。</translation>
    </message>
    <message>
        <source>This robot does not report what it sees.</source>
        <translation>该机器人不说明它看到什么。</translation>
    </message>
    <message>
        <source>The robot has not answered yet.</source>
        <translation>机器人尚未应答。</translation>
    </message>
    <message>
        <source>No %1 was added. %2</source>
        <translation>没有添加%1。%2</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Moved to where the robot sees it: %1</source>
        <translation>已移到机器人看到它的地方：%1</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Added where the robot sees it: %1</source>
        <translation>已添加到机器人看到它的地方：%1</translation>
    </message>
    <message>
        <source>What the robot has collected earlier could not be read. %1</source>
        <translation>无法读取机器人先前收集的内容。%1</translation>
    </message>
    <message>
        <source>The robot has collected no landmarks and has seen no barcodes since it was connected.</source>
        <translation>连接以来，机器人没有收集到路标，也没有看到条码。</translation>
    </message>
    <message numerus="yes">
        <source>%1 marks</source>
        <translation>
            <numerusform>%1 个标记</numerusform>
        </translation>
    </message>
    <message>
        <source>Taken from the robot: %1</source>
        <translation>取自机器人：%1</translation>
    </message>
    <message>
        <source>The newest %1 collections of the robot were read, of %2.</source>
        <translation>机器人共有 %2 次采集，已读取最新的 %1 次。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayTool</name>
    <message>
        <source>add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Loading the overlays. Esc leaves.</source>
        <translation>正在加载覆盖物。Esc 退出。</translation>
    </message>
    <message>
        <source>The overlays are being saved.</source>
        <translation>正在保存覆盖物。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlayTransfer</name>
    <message>
        <source>&amp;Copy overlays</source>
        <translation>复制覆盖物(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selection as GeoJSON, for another map or a text editor (Ctrl+C on the map)</source>
        <translation>把选中项复制为 GeoJSON，供另一张地图或文本编辑器使用（在地图上按 Ctrl+C）</translation>
    </message>
    <message>
        <source>C&amp;ut overlays</source>
        <translation>剪切覆盖物(&amp;U)</translation>
    </message>
    <message>
        <source>Copy the selection, then delete it (Ctrl+X on the map)</source>
        <translation>复制选中项，然后删除（在地图上按 Ctrl+X）</translation>
    </message>
    <message>
        <source>&amp;Paste overlays</source>
        <translation>粘贴覆盖物(&amp;P)</translation>
    </message>
    <message>
        <source>Paste overlays where they were copied from (Ctrl+V on the map)</source>
        <translation>把覆盖物粘贴到原来复制的位置（在地图上按 Ctrl+V）</translation>
    </message>
    <message>
        <source>Paste overlays in the &amp;view</source>
        <translation>把覆盖物粘贴到视图中(&amp;V)</translation>
    </message>
    <message>
        <source>Paste overlays in the middle of the view (Ctrl+Shift+V on the map: at the cursor)</source>
        <translation>把覆盖物粘贴到视图中央（在地图上按 Ctrl+Shift+V：粘贴到光标处）</translation>
    </message>
    <message>
        <source>Open the overlays of a map first.</source>
        <translation>请先打开一张地图的覆盖物。</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>没有选中任何内容。</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>已复制：%1</translation>
    </message>
    <message>
        <source>Nothing was pasted from the clipboard. %1</source>
        <translation>没有从剪贴板粘贴任何内容。%1</translation>
    </message>
    <message>
        <source>Pasted: %1</source>
        <translation>已粘贴：%1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlaysController</name>
    <message>
        <source>This version of the overlays is not in the history. %1</source>
        <translation>历史中没有覆盖物的这个版本。%1</translation>
    </message>
    <message>
        <source>bring back %1</source>
        <translation>恢复 %1</translation>
    </message>
    <message>
        <source>The overlays are here as in %1. Nothing was sent yet.</source>
        <translation>这里的覆盖物与 %1 中的相同，尚未下发。</translation>
    </message>
    <message>
        <source>Save this version</source>
        <translation>保存此版本</translation>
    </message>
    <message>
        <source>GeoJSON (*.geojson)</source>
        <translation>GeoJSON (*.geojson)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>restore the draft</source>
        <translation>恢复草稿</translation>
    </message>
    <message>
        <source>Edit &amp;overlays</source>
        <translation>编辑覆盖物(&amp;O)</translation>
    </message>
    <message>
        <source>Tool: Edit overlays</source>
        <translation>工具：编辑覆盖物</translation>
    </message>
    <message>
        <source>Edit walls, regions and points of the map on the robot</source>
        <translation>编辑机器人地图上的墙、区域和点</translation>
    </message>
    <message>
        <source>The unsaved changes to the overlays of %1 are kept as a draft.</source>
        <translation>%1 覆盖物的未保存更改已留作草稿。</translation>
    </message>
    <message>
        <source>Someone else changed overlays of %1: %2.</source>
        <translation>他人修改了 %1 的覆盖物：%2。</translation>
    </message>
    <message>
        <source>The overlays were not saved: the robot does not hold them.</source>
        <translation>覆盖物未保存：机器人上的内容与之不符。</translation>
    </message>
    <message>
        <source>The overlays are not saved yet: some were changed both here and in the file. Choose which version to keep.</source>
        <translation>覆盖物尚未保存：有些在这里和文件中都被更改。请选择保留哪个版本。</translation>
    </message>
    <message>
        <source>The overlays are not saved yet: some were changed both here and on the robot. Choose which version to keep.</source>
        <translation>覆盖物尚未保存：有些在这里和机器人上都被更改。请选择保留哪个版本。</translation>
    </message>
    <message>
        <source>The overlays were not saved. %1</source>
        <translation>覆盖物未保存。%1</translation>
    </message>
    <message>
        <source>Some of these have flaws: see the panel Overlays.</source>
        <translation>其中有些存在缺陷：见“覆盖物”面板。</translation>
    </message>
    <message>
        <source>It is not known whether the overlays were saved. %1</source>
        <translation>不知道覆盖物是否已保存。%1</translation>
    </message>
    <message>
        <source>%1 They are still unsaved here.</source>
        <translation>%1它们在这里仍未保存。</translation>
    </message>
    <message>
        <source>Overlays of %1 saved</source>
        <translation>%1 的覆盖物已保存</translation>
    </message>
    <message>
        <source>The overlays of this map cannot be read. %1</source>
        <translation>无法读取此地图的覆盖物。%1</translation>
    </message>
    <message>
        <source>The robot already has these overlays.</source>
        <translation>机器人已有这些覆盖物。</translation>
    </message>
    <message>
        <source>Walls and reachability are not checked yet: the map is being read.</source>
        <translation>尚未检查墙和可达性：正在读取地图。</translation>
    </message>
    <message>
        <source>Walls and reachability are not checked. %1</source>
        <translation>未检查墙和可达性。%1</translation>
    </message>
    <message>
        <source>Walls and reachability are not checked in this view. Show the whole map to check them.</source>
        <translation>此视图中不检查墙和可达性。要检查，请显示整张地图。</translation>
    </message>
    <message>
        <source>Connect to a robot to edit the overlays of its maps.</source>
        <translation>连接机器人以编辑其地图的覆盖物。</translation>
    </message>
    <message>
        <source>Open a map to edit its overlays.</source>
        <translation>打开一张地图以编辑其覆盖物。</translation>
    </message>
    <message>
        <source>Only stored maps have overlays. Open one in the Maps panel.</source>
        <translation>只有已存地图才有覆盖物。请在“地图”面板中打开一张。</translation>
    </message>
    <message>
        <source>The overlays could not be read. %1</source>
        <translation>无法读取覆盖物。%1</translation>
    </message>
    <message>
        <source>Loading the overlays.</source>
        <translation>正在加载覆盖物。</translation>
    </message>
    <message>
        <source>There is an unsaved draft of the overlays of this map from %1: %2.</source>
        <translation>此地图的覆盖物有一份 %1 的未保存草稿：%2。</translation>
    </message>
    <message>
        <source>Changes to the overlays are not backed up: save them soon. %1</source>
        <translation>覆盖物的更改没有备份：请尽快保存。%1</translation>
    </message>
    <message>
        <source>The changes to the overlays are lost. %1</source>
        <translation>覆盖物的更改已丢失。%1</translation>
    </message>
    <message>
        <source>Overlays are not saved</source>
        <translation>覆盖物未保存</translation>
    </message>
    <message>
        <source>Overlays of %1: %2 not saved.</source>
        <translation>%1 的覆盖物：%2未保存。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlaysDock</name>
    <message>
        <source>Overlays</source>
        <translation>覆盖物</translation>
    </message>
    <message>
        <source>Duplicate what is selected</source>
        <translation>复制选中项的副本</translation>
    </message>
    <message>
        <source>Delete what is selected (Delete)</source>
        <translation>删除选中项 (Delete)</translation>
    </message>
    <message>
        <source>From the robot</source>
        <translation>从机器人</translation>
    </message>
    <message>
        <source>Arrange what is selected</source>
        <translation>排列选中项</translation>
    </message>
    <message>
        <source>Snap overlays</source>
        <translation>吸附覆盖物</translation>
    </message>
    <message>
        <source>Defaults of the map</source>
        <translation>地图的默认值</translation>
    </message>
    <message>
        <source>Radius of new circles</source>
        <translation>新圆的半径</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>My version replaces theirs when it is saved</source>
        <translation>保存时我的版本替换对方的</translation>
    </message>
    <message>
        <source>Take theirs</source>
        <translation>采用对方的</translation>
    </message>
    <message>
        <source>My version of it is given up</source>
        <translation>放弃我的版本</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>All as the robot has it; can be undone</source>
        <translation>全部恢复为机器人上的样子；可以撤销</translation>
    </message>
    <message>
        <source>Review and save…</source>
        <translation>核对并保存…</translation>
    </message>
    <message>
        <source>Shows what changes before it is sent (Ctrl+S)</source>
        <translation>下发前显示改变的内容 (Ctrl+S)</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard draft</source>
        <translation>放弃草稿</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Earlier versions of the overlays</source>
        <translation>覆盖物的较早版本</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Flaws</source>
        <translation>缺陷</translation>
    </message>
    <message>
        <source>Select, move and reshape</source>
        <translation>选择、移动和改变形状</translation>
    </message>
    <message>
        <source>Draw a point</source>
        <translation>画点</translation>
    </message>
    <message>
        <source>Draw a line</source>
        <translation>画线</translation>
    </message>
    <message>
        <source>Draw a region by its outline</source>
        <translation>按轮廓画区域</translation>
    </message>
    <message>
        <source>Draw a rectangular region</source>
        <translation>画矩形区域</translation>
    </message>
    <message>
        <source>Draw a round region</source>
        <translation>画圆形区域</translation>
    </message>
    <message>
        <source>Type of what is drawn</source>
        <translation>所画内容的类型</translation>
    </message>
    <message>
        <source>by dragging</source>
        <translation>拖动确定</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Forbidden region</source>
        <translation>禁行区</translation>
    </message>
    <message>
        <source>changed, unsaved</source>
        <translation>已更改，未保存</translation>
    </message>
    <message>
        <source>Filter by name, type or id</source>
        <translation>按名称、类型或编号筛选</translation>
    </message>
    <message>
        <source>Filter overlays</source>
        <translation>筛选覆盖物</translation>
    </message>
    <message>
        <source>Filter overlays by state</source>
        <translation>按状态筛选覆盖物</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Unsaved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>Changed by others</source>
        <translation>已被他人修改</translation>
    </message>
    <message>
        <source>In conflict</source>
        <translation>有冲突</translation>
    </message>
    <message>
        <source>With flaws</source>
        <translation>有缺陷</translation>
    </message>
    <message>
        <source>Flaws (%1)</source>
        <translation>缺陷（%1）</translation>
    </message>
    <message>
        <source>Changed here and in the file (%1 of %2): %3, %4.
Mine: %5
Theirs: %6</source>
        <translation>在这里和文件中都被更改（%1 / %2）：%3，%4。
我的：%5
对方的：%6</translation>
    </message>
    <message>
        <source>Changed here and on the robot (%1 of %2): %3, %4.
Mine: %5
Theirs: %6</source>
        <translation>在这里和机器人上都被更改（%1 / %2）：%3，%4。
我的：%5
对方的：%6</translation>
    </message>
    <message>
        <source>defaults of the map</source>
        <translation>地图的默认值</translation>
    </message>
    <message>
        <source>&amp;Show on the map</source>
        <translation>在地图上显示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>C&amp;ut</source>
        <translation>剪切(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>复制副本(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>恢复(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>正在保存…</translation>
    </message>
    <message>
        <source>%1 %2 not saved.</source>
        <translation>%1 %2未保存。</translation>
    </message>
    <message>
        <source>%1, %2 not saved.</source>
        <translation>%1，%2未保存。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>There are no overlays on this map yet. Draw one on the map.</source>
        <translation>此地图上还没有覆盖物。请在地图上画一个。</translation>
    </message>
    <message>
        <source>No overlay matches the filter.</source>
        <translation>没有符合筛选的覆盖物。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::OverlaysModel</name>
    <message>
        <source>conflict</source>
        <translation>冲突</translation>
    </message>
    <message>
        <source>new, unsaved</source>
        <translation>新增，未保存</translation>
    </message>
    <message>
        <source>changed, unsaved</source>
        <translation>已更改，未保存</translation>
    </message>
    <message>
        <source>deleted, unsaved</source>
        <translation>已删除，未保存</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>changed in the file</source>
        <translation>在文件中被更改</translation>
    </message>
    <message>
        <source>changed on the robot</source>
        <translation>在机器人上被更改</translation>
    </message>
    <message>
        <source>Id %1</source>
        <translation>编号 %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::Panels</name>
    <message>
        <source>All panels here</source>
        <translation>这里的所有面板</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>面板</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PictureController</name>
    <message>
        <source>restore the draft</source>
        <translation>恢复草稿</translation>
    </message>
    <message>
        <source>&amp;Edit map</source>
        <translation>编辑地图(&amp;E)</translation>
    </message>
    <message>
        <source>Tool: Edit map</source>
        <translation>工具：编辑地图</translation>
    </message>
    <message>
        <source>Paint free, occupied and unknown areas</source>
        <translation>涂画空闲、占据和未知区域</translation>
    </message>
    <message>
        <source>Cop&amp;ies of overwritten maps…</source>
        <translation>被覆盖地图的备份(&amp;I)…</translation>
    </message>
    <message>
        <source>What robots had before their maps were overwritten; it can be put back</source>
        <translation>机器人的地图被覆盖之前的样子；可以放回</translation>
    </message>
    <message>
        <source>No copies are kept here.</source>
        <translation>这里没有保留副本。</translation>
    </message>
    <message>
        <source>The unsaved changes to the map %1 are kept as a draft.</source>
        <translation>地图 %1 的未保存更改已留作草稿。</translation>
    </message>
    <message>
        <source>It is still not known whether %1 was saved: its picture on the robot cannot be loaded.</source>
        <translation>仍不知道 %1 是否已保存：无法加载它在机器人上的图像。</translation>
    </message>
    <message>
        <source>Nothing was sent, because the robot&apos;s map could not be backed up: %1</source>
        <translation>没有下发任何内容，因为无法备份机器人的地图：%1</translation>
    </message>
    <message>
        <source>Since this draft was made, someone else has also changed these parts of the map: %1. Your changes are shown; use undo to see the others.</source>
        <translation>此草稿产生之后，他人也修改了地图的这些部分：%1。现在显示的是您的更改；用撤销可看到他人的更改。</translation>
    </message>
    <message>
        <source>There is an unsaved draft of this map from %1: %2.</source>
        <translation>此地图有一份 %1 的未保存草稿：%2。</translation>
    </message>
    <message>
        <source>Changes to the map are not backed up: save them soon. %1</source>
        <translation>地图的更改没有备份：请尽快保存。%1</translation>
    </message>
    <message>
        <source>The changes to the map are lost. %1</source>
        <translation>地图的更改已丢失。%1</translation>
    </message>
    <message>
        <source>The map was replaced by one of another size or position. The unsaved changes do not fit it and were discarded: %1.</source>
        <translation>地图已换成大小或位置不同的另一张。未保存的更改与之不符，已放弃：%1。</translation>
    </message>
    <message>
        <source>The oldest changes to this map can no longer be undone: that would take too much memory.</source>
        <translation>此地图最早的更改已不能撤销：那会占用太多内存。</translation>
    </message>
    <message>
        <source>Open a map file (Ctrl+Shift+O) to edit its picture.</source>
        <translation>打开地图文件 (Ctrl+Shift+O) 以编辑其图像。</translation>
    </message>
    <message>
        <source>The map is loading.</source>
        <translation>正在加载地图。</translation>
    </message>
    <message>
        <source>This is the robot&apos;s live map. The tool (B) edits &quot;%1&quot;, the stored map that the robot uses.</source>
        <translation>这是机器人的实时地图。该工具 (B) 编辑的是“%1”，即机器人使用的已存地图。</translation>
    </message>
    <message>
        <source>Only a whole map has a picture to edit. Open one in the Maps panel.</source>
        <translation>只有整张地图才有可编辑的图像。请在“地图”面板中打开一张。</translation>
    </message>
    <message>
        <source>Only stored maps can be edited, not the live one.</source>
        <translation>只能编辑已存地图，不能编辑实时地图。</translation>
    </message>
    <message>
        <source>Pictures of this format are read-only. Export the map as PGM and YAML and edit that.</source>
        <translation>此格式的图像只读。请把地图导出为 PGM 和 YAML，再编辑导出的文件。</translation>
    </message>
    <message>
        <source>Some cells of this map are neither free, occupied nor unknown but in between (%1 of 100), and the robot&apos;s map manager has no gray level for these, so the map could not be sent back. Export the map to edit it as files.</source>
        <translation>此地图的有些栅格既不是空闲、占据，也不是未知，而是介于其间（100 级中的 %1），机器人的地图管理器没有相应的灰度级，因此地图无法发回。请导出地图，作为文件编辑。</translation>
    </message>
    <message>
        <source>Parts of this map could not be read, so it cannot be saved.</source>
        <translation>此地图有部分内容无法读取，因此不能保存。</translation>
    </message>
    <message>
        <source>The map is not saved yet: some cells were changed both here and elsewhere. Choose which ones to keep.</source>
        <translation>地图尚未保存：有些栅格在这里和别处都被更改。请选择保留哪些。</translation>
    </message>
    <message>
        <source>Send the map to the robot</source>
        <translation>把地图下发到机器人</translation>
    </message>
    <message>
        <source>Overwrite %1 on the robot %2?</source>
        <translation>覆盖机器人 %2 上的 %1？</translation>
    </message>
    <message>
        <source>%1 changed. The robot will use the new picture. It does not keep the old one.</source>
        <translation>%1已更改。机器人将使用新图像，不保留旧图像。</translation>
    </message>
    <message>
        <source>A copy of the old picture is saved in %1 as a local map. The latest %2 copies of each map are kept.</source>
        <translation>旧图像的副本作为本地地图保存在 %1。每张地图保留最新的 %2 个副本。</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>下发</translation>
    </message>
    <message>
        <source>This is a copy of another map. To put it back, open its map from its robot first.</source>
        <translation>这是另一张地图的副本。要放回，请先从其机器人打开该地图。</translation>
    </message>
    <message>
        <source>The map is being saved.</source>
        <translation>正在保存地图。</translation>
    </message>
    <message>
        <source>The copy cannot be put back. %1</source>
        <translation>副本无法放回。%1</translation>
    </message>
    <message>
        <source>The copy cannot be put back: the map has another size or position now.</source>
        <translation>副本无法放回：地图现在的大小或位置已不同。</translation>
    </message>
    <message>
        <source>put back the copy of %1</source>
        <translation>放回 %1 的副本</translation>
    </message>
    <message>
        <source>This is the copy of %1, not saved yet. Ctrl+S sends it, Ctrl+Z takes it back.</source>
        <translation>这是 %1 的副本，尚未保存。Ctrl+S 下发，Ctrl+Z 撤回。</translation>
    </message>
    <message>
        <source>The map already equals the copy of %1.</source>
        <translation>地图已与 %1 的副本相同。</translation>
    </message>
    <message>
        <source>The map was not saved. %1</source>
        <translation>地图未保存。%1</translation>
    </message>
    <message>
        <source>%1 was saved: the robot has the new picture.</source>
        <translation>%1 已保存：机器人上是新图像。</translation>
    </message>
    <message>
        <source>%1 was not saved: the robot has the same picture as before.</source>
        <translation>%1 未保存：机器人上的图像与之前相同。</translation>
    </message>
    <message>
        <source>%1 was not saved as it was sent: the robot has another picture.</source>
        <translation>%1 没有按下发的内容保存：机器人上是另一幅图像。</translation>
    </message>
    <message>
        <source>%1 saved</source>
        <translation>%1 已保存</translation>
    </message>
    <message>
        <source>%1 saved. Previous version: %2</source>
        <translation>%1 已保存。前一版本：%2</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>打开它</translation>
    </message>
    <message>
        <source>It was changed elsewhere in the meantime and is being reloaded.</source>
        <translation>它在此期间于别处被更改，正在重新加载。</translation>
    </message>
    <message>
        <source>It is not known whether %1 was saved. %2 A message will say so once its picture has been read again.</source>
        <translation>不知道 %1 是否已保存。%2 重新读取其图像后会有消息说明。</translation>
    </message>
    <message>
        <source>%1 was changed elsewhere. The two versions were merged.</source>
        <translation>%1 在别处被更改。两个版本已合并。</translation>
    </message>
    <message>
        <source>The map is not saved</source>
        <translation>地图未保存</translation>
    </message>
    <message>
        <source>Changes to %1 are not saved: %2.</source>
        <translation>%1 的更改未保存：%2。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PictureDialog</name>
    <message>
        <source>The resolution must be a number in metres, for example 0.05.</source>
        <translation>分辨率必须是以米为单位的数字，例如 0.05。</translation>
    </message>
    <message>
        <source>The resolution must be greater than 0: it is the edge length of a cell in metres.</source>
        <translation>分辨率必须大于 0：它是栅格的边长，单位为米。</translation>
    </message>
    <message>
        <source>The origin needs three numbers: x and y in metres, yaw in degrees.</source>
        <translation>原点需要三个数字：x 和 y 以米为单位，朝向以度为单位。</translation>
    </message>
    <message>
        <source>How large is a cell, and where is the lower-left corner of the picture?</source>
        <translation>一个栅格有多大，图像的左下角在哪里？</translation>
    </message>
    <message>
        <source>%1 is a picture without a map.yaml. %2</source>
        <translation>%1 是没有 map.yaml 的图像。%2</translation>
    </message>
    <message>
        <source>Several map.yaml files name %1: %2. Open the right one instead, or enter the values here. %3</source>
        <translation>有多个 map.yaml 文件指向 %1：%2。请改为打开正确的那个，或在这里输入数值。%3</translation>
    </message>
    <message>
        <source>Position of the picture</source>
        <translation>图像的位置</translation>
    </message>
    <message>
        <source>&amp;Resolution, metres per cell</source>
        <translation>分辨率，每栅格米数(&amp;R)</translation>
    </message>
    <message>
        <source>Origin &amp;x, metres</source>
        <translation>原点 x，米(&amp;X)</translation>
    </message>
    <message>
        <source>Origin &amp;y, metres</source>
        <translation>原点 y，米(&amp;Y)</translation>
    </message>
    <message>
        <source>Origin ya&amp;w, degrees</source>
        <translation>原点朝向，度(&amp;W)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PictureDock</name>
    <message>
        <source>Edit map</source>
        <translation>编辑地图</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard draft</source>
        <translation>放弃草稿</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Brush: paint freehand</source>
        <translation>画笔：自由涂画</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>橡皮</translation>
    </message>
    <message>
        <source>Eraser: restore the saved map where you paint</source>
        <translation>橡皮：涂过的地方恢复为已保存的地图</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线</translation>
    </message>
    <message>
        <source>Line: a straight wall, as wide as the brush</source>
        <translation>线：一段直墙，宽度与画笔相同</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Rectangle: filled</source>
        <translation>矩形：填充</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Polygon: filled, corner by corner</source>
        <translation>多边形：填充，逐个顶点绘制</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Fill: a connected area of the same kind</source>
        <translation>填充：同类的连通区域</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Select: a part to copy, move, paint or clean up</source>
        <translation>选择：要复制、移动、涂画或清理的部分</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>Occupied</source>
        <translation>占据</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source> cells</source>
        <translation> 个栅格</translation>
    </message>
    <message>
        <source>Size of the brush</source>
        <translation>画笔的大小</translation>
    </message>
    <message>
        <source>Width of brush, eraser and line (on the map: comma and full stop)</source>
        <translation>画笔、橡皮和线的宽度（在地图上：逗号和句号键）</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>涂画</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Clean up</source>
        <translation>清理</translation>
    </message>
    <message>
        <source>Specks up to</source>
        <translation>噪点不超过</translation>
    </message>
    <message>
        <source>Removes groups of at most this many occupied cells: they become like their surroundings</source>
        <translation>移除占据栅格数不超过此值的小块：变得与周围相同</translation>
    </message>
    <message>
        <source>Gaps in walls up to</source>
        <translation>墙的缝隙不超过</translation>
    </message>
    <message>
        <source>Closes gaps of at most this many cells between occupied cells</source>
        <translation>填补占据栅格之间不超过此栅格数的缝隙</translation>
    </message>
    <message>
        <source>Ragged edges up to</source>
        <translation>毛刺边缘不超过</translation>
    </message>
    <message>
        <source>Smooths spikes and notches of at most this width between free and unknown areas</source>
        <translation>平滑空闲与未知区域之间不超过此宽度的尖刺和缺口</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Show the result without changing anything</source>
        <translation>显示结果，不改变任何内容</translation>
    </message>
    <message>
        <source>Preview: %1</source>
        <translation>预览：%1</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>Take theirs</source>
        <translation>采用对方的</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Before…</source>
        <translation>对比之前…</translation>
    </message>
    <message>
        <source>Compare the saved map with the current one, with a divider that can be dragged</source>
        <translation>用可拖动的分隔线比较已保存的地图与当前地图</translation>
    </message>
    <message>
        <source>Copies…</source>
        <translation>副本…</translation>
    </message>
    <message>
        <source>What the robot had before it was overwritten; it can be put back</source>
        <translation>机器人的地图被覆盖之前的样子；可以放回</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Restore the saved map; can be undone</source>
        <translation>恢复已保存的地图；可以撤销</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop sending; the robot keeps its current picture</source>
        <translation>停止下发；机器人保留其当前图像</translation>
    </message>
    <message>
        <source>Save the picture of the map (Ctrl+S). Its map.yaml is not changed</source>
        <translation>保存地图的图像 (Ctrl+S)，其 map.yaml 不变</translation>
    </message>
    <message>
        <source>Send the picture to the robot (Ctrl+S). Its position, size and resolution stay the same</source>
        <translation>把图像下发到机器人 (Ctrl+S)，其位置、大小和分辨率不变</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>正在保存…</translation>
    </message>
    <message>
        <source>Sending: %1 %</source>
        <translation>正在下发：%1%</translation>
    </message>
    <message>
        <source>Sent. Waiting for the robot to show it…</source>
        <translation>已下发。正在等待机器人显示…</translation>
    </message>
    <message>
        <source>No unsaved changes.</source>
        <translation>没有未保存的更改。</translation>
    </message>
    <message>
        <source>Changed: %1.</source>
        <translation>已更改：%1。</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>Preparing the preview…</source>
        <translation>正在准备预览…</translation>
    </message>
    <message>
        <source>There is nothing to clean up.</source>
        <translation>没有可清理的内容。</translation>
    </message>
    <message>
        <source>Changes %1.</source>
        <translation>改变 %1。</translation>
    </message>
    <message numerus="yes">
        <source>%1 specks</source>
        <translation>
            <numerusform>%1 处噪点</numerusform>
        </translation>
    </message>
    <message>
        <source>Removes %1 (%2).</source>
        <translation>移除 %1（%2）。</translation>
    </message>
    <message>
        <source>Free: where robots may drive</source>
        <translation>空闲：机器人可以行驶的地方</translation>
    </message>
    <message>
        <source>Occupied: walls and other obstacles</source>
        <translation>占据：墙和其他障碍物</translation>
    </message>
    <message>
        <source>Unknown: not observed yet</source>
        <translation>未知：尚未观测到</translation>
    </message>
    <message>
        <source>According to its map.yaml, no gray level of this picture means unknown.</source>
        <translation>按其 map.yaml，此图像没有灰度值表示未知。</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Applies to the whole map. To clean up only a part, select it.</source>
        <translation>作用于整张地图。只想清理一部分时，请先选择该部分。</translation>
    </message>
    <message>
        <source>Applies to the selection.</source>
        <translation>作用于选中部分。</translation>
    </message>
    <message>
        <source>becomes free: %1</source>
        <translation>变为空闲：%1</translation>
    </message>
    <message>
        <source>becomes occupied: %1</source>
        <translation>变为占据：%1</translation>
    </message>
    <message>
        <source>becomes unknown: %1</source>
        <translation>变为未知：%1</translation>
    </message>
    <message>
        <source>Changed differently here and elsewhere: %1. Which version do you want to keep?</source>
        <translation>在这里和别处改得不同：%1。保留哪个版本？</translation>
    </message>
    <message>
        <source>Not all of it is marked on the map.</source>
        <translation>并非全部都标在地图上。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PictureSwipe</name>
    <message>
        <source>Drag it, or press Left and Right, to reveal one picture or the other</source>
        <translation>拖动它，或按左右方向键，显示其中一幅图像</translation>
    </message>
    <message>
        <source>Divider between %1 and %2</source>
        <translation>%1 与 %2 之间的分隔线</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PictureTool</name>
    <message>
        <source>This area is too large to change at once. Draw lines to divide it, then change the parts.</source>
        <translation>此区域太大，无法一次更改。请画线把它分开，再分别更改。</translation>
    </message>
    <message>
        <source>The selection is too large to be copied. Select a smaller one.</source>
        <translation>选中部分太大，无法复制。请选小一些。</translation>
    </message>
    <message>
        <source>Computing… Esc cancels. Anything you draw meanwhile is applied afterwards.</source>
        <translation>正在计算… Esc 取消。期间所画的内容稍后应用。</translation>
    </message>
    <message>
        <source>Preparing the preview… Esc cancels.</source>
        <translation>正在准备预览… Esc 取消。</translation>
    </message>
    <message>
        <source>This is a preview. Enter applies it, Esc discards it.</source>
        <translation>这是预览。Enter 应用，Esc 放弃。</translation>
    </message>
    <message>
        <source>Drag to paint. Comma and full stop change the size; Space and drag moves the map. Esc leaves.</source>
        <translation>拖动以涂画。逗号和句号键改变大小；按住空格拖动可移动地图。Esc 退出。</translation>
    </message>
    <message>
        <source>Drag over the parts to restore to the saved map. Esc leaves.</source>
        <translation>拖过要恢复为已保存地图的部分。Esc 退出。</translation>
    </message>
    <message>
        <source>Drag from one end to the other. Esc leaves.</source>
        <translation>从一端拖到另一端。Esc 退出。</translation>
    </message>
    <message>
        <source>Drag from corner to corner. Esc leaves.</source>
        <translation>从一角拖到另一角。Esc 退出。</translation>
    </message>
    <message>
        <source>Click the corners of the area to paint. Esc leaves.</source>
        <translation>依次单击要涂画区域的顶点。Esc 退出。</translation>
    </message>
    <message>
        <source>Click the next corner. Click the first one or press Enter to paint. Backspace removes the last corner.</source>
        <translation>单击下一个顶点。单击第一个顶点或按 Enter 即涂画。Backspace 移除最后一个顶点。</translation>
    </message>
    <message>
        <source>Click an area to fill it. Esc leaves.</source>
        <translation>单击一个区域以填充。Esc 退出。</translation>
    </message>
    <message>
        <source>Drag around the part to copy, move or clean up. Esc leaves.</source>
        <translation>拖动框选要复制、移动或清理的部分。Esc 退出。</translation>
    </message>
    <message>
        <source>Drag to move it (Ctrl: copy it), Ctrl+C copies, Ctrl+V pastes at the cursor, Delete paints it.</source>
        <translation>拖动以移动（Ctrl：复制），Ctrl+C 复制，Ctrl+V 粘贴到光标处，Delete 涂画。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PlacePreview</name>
    <message>
        <source>Where the picture lies</source>
        <translation>图像所在的位置</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PlacesModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message numerus="yes">
        <source>and %1 others</source>
        <translation>
            <numerusform>及另外 %1 个</numerusform>
        </translation>
    </message>
    <message>
        <source>occupied in %1 cells, free in %2</source>
        <translation>%1 个栅格中为占据，%2 个中为空闲</translation>
    </message>
    <message>
        <source>How many cells contradict within a square of 1 m</source>
        <translation>1 m 见方内有多少个栅格相互矛盾</translation>
    </message>
    <message>
        <source>Those that disagree, in most of the cells first; point at a row for what each of them says</source>
        <translation>相互不一致的子图，矛盾栅格最多的在前；指向一行可看各子图的内容</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>栅格</translation>
    </message>
    <message>
        <source>x (m)</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y (m)</source>
        <translation>y (m)</translation>
    </message>
    <message>
        <source>Submaps</source>
        <translation>子图</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PlacingActions</name>
    <message>
        <source>&amp;New waypoint</source>
        <translation>新路径点(&amp;N)</translation>
    </message>
    <message>
        <source>At the &amp;robot</source>
        <translation>在机器人处新建(&amp;R)</translation>
    </message>
    <message>
        <source>A waypoint at the robot&apos;s position and heading</source>
        <translation>在机器人的位置和朝向处放一个路径点</translation>
    </message>
    <message>
        <source>At &amp;coordinates…</source>
        <translation>在坐标处(&amp;C)…</translation>
    </message>
    <message>
        <source>A waypoint with a given name, position and heading</source>
        <translation>按给定的名称、位置和朝向放一个路径点</translation>
    </message>
    <message>
        <source>Along a &amp;line</source>
        <translation>沿线布置(&amp;L)</translation>
    </message>
    <message>
        <source>Evenly spaced waypoints along a line, heading along it</source>
        <translation>沿一条线等距布置路径点，朝向沿线方向</translation>
    </message>
    <message>
        <source>D&amp;uplicate waypoints</source>
        <translation>复制路径点副本(&amp;U)</translation>
    </message>
    <message>
        <source>Copy the selected waypoints, next to the originals</source>
        <translation>在原处旁边复制选中的路径点</translation>
    </message>
    <message>
        <source>Select all &amp;waypoints</source>
        <translation>选择所有路径点(&amp;W)</translation>
    </message>
    <message>
        <source>All waypoints of the map</source>
        <translation>地图的所有路径点</translation>
    </message>
    <message>
        <source>&amp;Invert the selection</source>
        <translation>反选(&amp;I)</translation>
    </message>
    <message>
        <source>Select the waypoints that are not selected, and deselect the others</source>
        <translation>选择未选中的路径点，并取消选择其他的</translation>
    </message>
    <message>
        <source>The position of the robot is unknown.</source>
        <translation>机器人的位置未知。</translation>
    </message>
    <message>
        <source>The robot is not in the map on screen.</source>
        <translation>机器人不在屏幕上的地图中。</translation>
    </message>
    <message>
        <source>Open a map to place waypoints in it.</source>
        <translation>打开一张地图，在其中放置路径点。</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>没有选中任何内容。</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>duplicate %1</source>
        <translation>复制 %1 的副本</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PlacingDialog</name>
    <message>
        <source>Distances</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>&amp;Grid to snap to</source>
        <translation>吸附的网格(&amp;G)</translation>
    </message>
    <message>
        <source>Distance to &amp;walls</source>
        <translation>与墙的距离(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Radius of the robot</source>
        <translation>机器人半径(&amp;R)</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>不检查</translation>
    </message>
    <message>
        <source>The robot reports its own footprint, which is used instead.</source>
        <translation>机器人报告了自身外形，因此改用它。</translation>
    </message>
    <message>
        <source>Waypoints closer to a wall than this get a warning. This robot does not report its footprint.</source>
        <translation>离墙比此更近的路径点会有警告。该机器人没有报告其外形。</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PlotSelection</name>
    <message>
        <source>Position x</source>
        <translation>位置 x</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>位置 y</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Localization quality</source>
        <translation>定位质量</translation>
    </message>
    <message>
        <source>Matching score</source>
        <translation>匹配得分</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PlotWidget</name>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation>移除此曲线图</translation>
    </message>
    <message>
        <source>Show the whole time range</source>
        <translation>显示整个时间范围</translation>
    </message>
    <message>
        <source>Values: fit automatically</source>
        <translation>数值：自动适应</translation>
    </message>
    <message>
        <source>Values: keep this range</source>
        <translation>数值：保持此范围</translation>
    </message>
    <message>
        <source>Values: range…</source>
        <translation>数值：范围…</translation>
    </message>
    <message>
        <source>Time as seconds since the start</source>
        <translation>时间为自开始的秒数</translation>
    </message>
    <message>
        <source>Range of values</source>
        <translation>数值范围</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>从(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>至(&amp;T)</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PlotsDock</name>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>新曲线图</translation>
    </message>
    <message>
        <source>Whole bag</source>
        <translation>整个数据包</translation>
    </message>
    <message>
        <source>Field, for example /topic.member[0]</source>
        <translation>字段，例如 /topic.member[0]</translation>
    </message>
    <message>
        <source>Field to plot</source>
        <translation>要绘制曲线的字段</translation>
    </message>
    <message>
        <source>Plot this field of the messages of a topic</source>
        <translation>绘制某话题消息中此字段的曲线</translation>
    </message>
    <message>
        <source>Add another plot below</source>
        <translation>在下方添加另一个曲线图</translation>
    </message>
    <message>
        <source>Read the whole bag, not only the part that is shown</source>
        <translation>读取整个数据包，而不只是显示的部分</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>物理量</translation>
    </message>
    <message>
        <source>Plot pose, speed and more</source>
        <translation>绘制位姿、速度等的曲线</translation>
    </message>
    <message>
        <source>Pose: x, y and heading</source>
        <translation>位姿：x、y 和朝向</translation>
    </message>
    <message>
        <source>No longer plotted: %1</source>
        <translation>不再绘制：%1</translation>
    </message>
    <message>
        <source>There are already as many curves as can be told apart. Remove one first: right-click the plot.</source>
        <translation>曲线已多到难以分辨。请先移除一条：右键单击曲线图。</translation>
    </message>
    <message>
        <source>%1 is already in this plot.</source>
        <translation>%1 已在此曲线图中。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a field. Enter a topic and a member of its messages, for example /topic.member[0].</source>
        <translation>“%1”不是字段。请输入话题及其消息的成员，例如 /topic.member[0]。</translation>
    </message>
    <message>
        <source>No message so far has a number %1. It will be drawn as soon as one does.</source>
        <translation>目前没有消息含有数字 %1。一旦有了就会绘制。</translation>
    </message>
    <message>
        <source>Drop a number from a message here, type its name above, or choose a quantity.</source>
        <translation>把消息中的数字拖到这里，在上面输入其名称，或选择一个物理量。</translation>
    </message>
    <message>
        <source>The part of the bag that has been read so far has no such data.</source>
        <translation>目前读取的数据包部分没有此类数据。</translation>
    </message>
    <message>
        <source>No data has arrived yet.</source>
        <translation>尚未收到数据。</translation>
    </message>
    <message>
        <source>Open a recording or connect to a robot to see curves.</source>
        <translation>打开录制文件或连接机器人以查看曲线。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PoseController</name>
    <message>
        <source>Set the robot&apos;s &amp;pose…</source>
        <translation>重定位机器人(&amp;P)…</translation>
    </message>
    <message>
        <source>Tell the robot where it is on its map</source>
        <translation>告诉机器人它在地图上的位置</translation>
    </message>
    <message>
        <source>Place the robo&amp;t</source>
        <translation>放置机器人(&amp;T)</translation>
    </message>
    <message>
        <source>Click where the robot is; drag towards where it looks</source>
        <translation>单击机器人所在处；朝它面对的方向拖动</translation>
    </message>
    <message>
        <source>There is no robot.</source>
        <translation>没有机器人。</translation>
    </message>
    <message>
        <source>The robot is not connected.</source>
        <translation>机器人未连接。</translation>
    </message>
    <message>
        <source>The map on screen is not the one that the robot uses: show that one first.</source>
        <translation>屏幕上的地图不是机器人使用的那张：请先显示机器人使用的地图。</translation>
    </message>
    <message>
        <source>Waiting for the robot to say where it is…</source>
        <translation>正在等待机器人说明它在哪里…</translation>
    </message>
    <message>
        <source>The robot is searching its map for its position…</source>
        <translation>机器人正在地图上搜索自己的位置…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PoseDock</name>
    <message>
        <source>Robot&apos;s pose</source>
        <translation>重定位</translation>
    </message>
    <message>
        <source>The robot may &amp;adjust it</source>
        <translation>允许机器人微调(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Place on the map</source>
        <translation>在地图上放置(&amp;P)</translation>
    </message>
    <message>
        <source>Click where the robot is; drag towards where it looks</source>
        <translation>单击机器人所在处；朝它面对的方向拖动</translation>
    </message>
    <message>
        <source>&amp;Set pose</source>
        <translation>重定位(&amp;S)</translation>
    </message>
    <message>
        <source>Tell the robot that it is there</source>
        <translation>告诉机器人它在那里</translation>
    </message>
    <message>
        <source>&amp;Find itself</source>
        <translation>自行定位(&amp;F)</translation>
    </message>
    <message>
        <source>Make the robot search its whole map for its position</source>
        <translation>让机器人在整张地图上搜索自己的位置</translation>
    </message>
    <message>
        <source>It &amp;is there</source>
        <translation>它在那里(&amp;I)</translation>
    </message>
    <message>
        <source>Set the pose that the robot proposes</source>
        <translation>采用机器人建议的位姿</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>否(&amp;N)</translation>
    </message>
    <message>
        <source>Leave the robot&apos;s pose as it is</source>
        <translation>机器人的位姿保持不变</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>x of the pose</source>
        <translation>位姿的 x</translation>
    </message>
    <message>
        <source>y of the pose</source>
        <translation>位姿的 y</translation>
    </message>
    <message>
        <source>Heading of the pose</source>
        <translation>位姿的朝向</translation>
    </message>
    <message>
        <source>The robot may correct the pose with its sensors. Otherwise it uses exactly this pose.</source>
        <translation>机器人可用传感器修正该位姿；否则精确采用该位姿。</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>&amp;x</source>
        <translation>&amp;x</translation>
    </message>
    <message>
        <source>&amp;y</source>
        <translation>&amp;y</translation>
    </message>
    <message>
        <source>&amp;Heading</source>
        <translation>朝向(&amp;H)</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PoseTool</name>
    <message>
        <source>Click where the robot is; drag towards where it looks. Esc leaves.</source>
        <translation>单击机器人所在处；朝它面对的方向拖动。Esc 退出。</translation>
    </message>
    <message>
        <source>%1. Click or drag again, then set it in the panel. Esc leaves.</source>
        <translation>%1。可再次单击或拖动，然后在面板中重定位。Esc 退出。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PresetMenu</name>
    <message>
        <source>Layer &amp;presets</source>
        <translation>图层预设(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Save the layers as a preset…</source>
        <translation>把图层保存为预设(&amp;S)…</translation>
    </message>
    <message>
        <source>Save which layers are shown, and how they are drawn</source>
        <translation>保存显示哪些图层以及如何绘制</translation>
    </message>
    <message>
        <source>Layers: %1</source>
        <translation>图层：%1</translation>
    </message>
    <message>
        <source>Show the layers of this preset</source>
        <translation>显示此预设的图层</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Save the layers as a preset</source>
        <translation>把图层保存为预设</translation>
    </message>
    <message>
        <source>Rename the preset</source>
        <translation>重命名预设</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PresetNameDialog</name>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>This preset is always there. Choose another name.</source>
        <translation>此预设始终存在，请选择其他名称。</translation>
    </message>
    <message>
        <source>Replaces your preset of this name.</source>
        <translation>将替换您的同名预设。</translation>
    </message>
    <message>
        <source>Another of your presets has this name.</source>
        <translation>您的另一个预设已用此名称。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProblemsController</name>
    <message>
        <source>Show problems</source>
        <translation>显示问题</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProblemsDock</name>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Copy selected</source>
        <translation>复制选中项</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>全部复制</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Repeat the requests for everything that failed or was missing</source>
        <translation>对失败或缺失的内容重复所有请求</translation>
    </message>
    <message>
        <source>All problems copied</source>
        <translation>所有问题已复制</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>没有问题。</translation>
    </message>
    <message>
        <source>%1, %2 unresolved</source>
        <translation>%1，%2 个未解决</translation>
    </message>
    <message>
        <source>, %1 older ones dropped</source>
        <translation>，已丢弃 %1 个较旧的</translation>
    </message>
    <message numerus="yes">
        <source>%1 problems copied</source>
        <translation>
            <numerusform>已复制 %1 个问题</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProblemsModel</name>
    <message>
        <source>First %1, last %2.</source>
        <translation>首次 %1，最近 %2。</translation>
    </message>
    <message>
        <source>At %1.</source>
        <translation>发生于 %1。</translation>
    </message>
    <message>
        <source>Resolved %1, after %2.</source>
        <translation>于 %1 解决，历时 %2。</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Lasted</source>
        <translation>历时</translation>
    </message>
    <message>
        <source>What</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>发生了什么</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProjectionTool</name>
    <message>
        <source>Waiting for the robot. Esc leaves.</source>
        <translation>正在等待机器人。Esc 退出。</translation>
    </message>
    <message>
        <source>Projections cannot be set on this robot, and there are none to select. Esc leaves.</source>
        <translation>该机器人不能设置投影，也没有可选的投影。Esc 退出。</translation>
    </message>
    <message>
        <source>Projections cannot be set on this robot: click one to select it. Esc leaves.</source>
        <translation>该机器人不能设置投影：单击一个以选择。Esc 退出。</translation>
    </message>
    <message>
        <source>Click a projection to select it. Esc leaves.</source>
        <translation>单击一个投影以选择。Esc 退出。</translation>
    </message>
    <message>
        <source>%1 x %2</source>
        <translation>%1 x %2</translation>
    </message>
    <message>
        <source>%1 x %2. Drag it or its edges; Delete removes it. Esc leaves.</source>
        <translation>%1 x %2。拖动它或其边；Delete 移除。Esc 退出。</translation>
    </message>
    <message>
        <source>Drag a rectangle for a new projection, or click one to select it. Esc leaves.</source>
        <translation>拖出矩形以新建投影，或单击一个以选择。Esc 退出。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProjectionsController</name>
    <message>
        <source>Edit pro&amp;jections</source>
        <translation>编辑投影(&amp;J)</translation>
    </message>
    <message>
        <source>Draw the regions that the robot projects to 2D maps</source>
        <translation>绘制机器人投影为 2D 地图的区域</translation>
    </message>
    <message>
        <source>Projections</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>The edited projections have not been set on the robot. Discard them?</source>
        <translation>编辑过的投影尚未设置到机器人。放弃它们？</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Connect to a robot with a map dispatcher to see its projections.</source>
        <translation>连接带地图分发器的机器人，即可查看其投影。</translation>
    </message>
    <message>
        <source>This robot has no service for projections (set_map_projections).</source>
        <translation>该机器人没有投影服务 (set_map_projections)。</translation>
    </message>
    <message>
        <source>The robot has answered. Your edits are kept; Revert shows the robot&apos;s answer.</source>
        <translation>机器人已应答。您的编辑已保留；“还原”会显示机器人的应答。</translation>
    </message>
    <message>
        <source>The robot has more projections, but nothing has arrived for them: %1.</source>
        <translation>机器人还有更多投影，但没有收到其内容：%1。</translation>
    </message>
    <message>
        <source>The robot accepted the projections.</source>
        <translation>机器人已接受投影。</translation>
    </message>
    <message numerus="yes">
        <source>The robot has answered, but %1 projections differ from what was sent. The table shows its answer.</source>
        <translation>
            <numerusform>机器人已应答，但有 %1 个投影与下发的不同。表格显示其应答。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProjectionsDock</name>
    <message>
        <source>Projections</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新加载</translation>
    </message>
    <message>
        <source>Ask the robot for its current projections</source>
        <translation>向机器人询问其当前投影</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add a projection of the visible area</source>
        <translation>添加可见范围的投影</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>在地图上</translation>
    </message>
    <message>
        <source>Draw, select and move the rectangles on the map</source>
        <translation>在地图上绘制、选择和移动矩形</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the selected projection from the list (Delete)</source>
        <translation>从列表移除选中的投影 (Delete)</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Back to the robot&apos;s projections</source>
        <translation>回到机器人的投影</translation>
    </message>
    <message>
        <source>Set on the robot</source>
        <translation>设置到机器人</translation>
    </message>
    <message>
        <source>In metres; X and Y are those of the lower left corner.</source>
        <translation>单位为米；X 和 Y 是左下角的坐标。</translation>
    </message>
    <message>
        <source>Projections cannot be set on this robot.</source>
        <translation>该机器人不能设置投影。</translation>
    </message>
    <message>
        <source>The robot is not connected.</source>
        <translation>机器人未连接。</translation>
    </message>
    <message>
        <source>Send the whole list; the robot&apos;s answer is shown afterwards</source>
        <translation>下发整个列表；之后显示机器人的应答</translation>
    </message>
    <message>
        <source>Waiting for the robot…</source>
        <translation>正在等待机器人…</translation>
    </message>
    <message>
        <source>The robot has not reported its projections yet.</source>
        <translation>机器人尚未报告其投影。</translation>
    </message>
    <message>
        <source>This robot does not report its projections.</source>
        <translation>该机器人不报告其投影。</translation>
    </message>
    <message>
        <source>Projection %1 cannot be sent. %2</source>
        <translation>投影 %1 无法下发。%2</translation>
    </message>
    <message>
        <source>Edited here, not set on the robot yet.</source>
        <translation>在这里编辑过，尚未设置到机器人。</translation>
    </message>
    <message>
        <source>The robot has no projections.</source>
        <translation>机器人没有投影。</translation>
    </message>
    <message numerus="yes">
        <source>The robot has %1 projections.</source>
        <translation>
            <numerusform>机器人有 %1 个投影。</numerusform>
        </translation>
    </message>
    <message>
        <source>They are read-only here: the robot offers no service to set them.</source>
        <translation>它们在这里只读：机器人没有提供设置它们的服务。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ProjectionsModel</name>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Of the lower left corner, metres</source>
        <translation>左下角的坐标，米</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Width, metres</source>
        <translation>宽度，米</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Height on the map, metres</source>
        <translation>地图上的高度，米</translation>
    </message>
    <message>
        <source>z from</source>
        <translation>z 从</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>One of its values is not a number.</source>
        <translation>其中有值不是数字。</translation>
    </message>
    <message>
        <source>It is more than 10,000 km away.</source>
        <translation>它在 10,000 km 以外。</translation>
    </message>
    <message>
        <source>Its width and height must be greater than 0.</source>
        <translation>其宽度和高度必须大于 0。</translation>
    </message>
    <message>
        <source>Its lower height must be below its upper height.</source>
        <translation>其下限高度必须低于上限高度。</translation>
    </message>
    <message>
        <source>of the map</source>
        <translation>地图的</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>全部复制</translation>
    </message>
    <message>
        <source>Show on the map</source>
        <translation>在地图上显示</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Properties copied</source>
        <translation>属性已复制</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>没有选中任何内容</translation>
    </message>
    <message>
        <source>Click something on the map, or choose it in Objects.</source>
        <translation>单击地图上的内容，或在“对象”中选择。</translation>
    </message>
    <message>
        <source>It is no longer on the map. Last known:</source>
        <translation>它已不在地图上。最后已知：</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RangeExportDialog</name>
    <message>
        <source>Messages, can be replayed (MCAP)</source>
        <translation>消息，可以回放 (MCAP)</translation>
    </message>
    <message>
        <source>Messages, one per line (JSON lines)</source>
        <translation>消息，每行一条 (JSON lines)</translation>
    </message>
    <message>
        <source>Path of the robot (GeoJSON)</source>
        <translation>机器人的路径 (GeoJSON)</translation>
    </message>
    <message>
        <source>Path of the robot (CSV)</source>
        <translation>机器人的路径 (CSV)</translation>
    </message>
    <message>
        <source>Path of the robot (TUM)</source>
        <translation>机器人的路径 (TUM)</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>从这里</translation>
    </message>
    <message>
        <source>To here</source>
        <translation>到这里</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>浏览(&amp;B)…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Export a range of the bag</source>
        <translation>导出数据包的一段</translation>
    </message>
    <message>
        <source>The time (UTC):
14:36:17.5, 2023-10-31 14:36:17, +1:30 after the start, -10 before the end</source>
        <translation>时间 (UTC)：
14:36:17.5、2023-10-31 14:36:17、+1:30 表示开始之后、-10 表示结束之前</translation>
    </message>
    <message>
        <source>Command that makes a video of this range</source>
        <translation>生成此段视频的命令</translation>
    </message>
    <message>
        <source>The time that the replay shows now</source>
        <translation>回放当前显示的时间</translation>
    </message>
    <message>
        <source>F&amp;rom (UTC)</source>
        <translation>从 (UTC)(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;To (UTC)</source>
        <translation>至 (UTC)(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>内容(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Video by &amp;command</source>
        <translation>用命令生成视频(&amp;C)</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>导出到</translation>
    </message>
    <message>
        <source>From and to must be times between %1 and %2.</source>
        <translation>起止时间必须在 %1 与 %2 之间。</translation>
    </message>
    <message>
        <source>The end is before the start.</source>
        <translation>结束早于开始。</translation>
    </message>
    <message>
        <source>Enter a file name.</source>
        <translation>请输入文件名。</translation>
    </message>
    <message>
        <source>%1 is a folder. Enter a file name.</source>
        <translation>%1 是文件夹，请输入文件名。</translation>
    </message>
    <message>
        <source>The folder %1 does not exist.</source>
        <translation>文件夹 %1 不存在。</translation>
    </message>
    <message>
        <source>%1 is the recording being played. Choose another name.</source>
        <translation>%1 是正在播放的录制文件，请另选名称。</translation>
    </message>
    <message>
        <source>%1 already exists. Press Export again to replace it.</source>
        <translation>%1 已存在。再按一次“导出”会替换它。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Nothing was written: %1 to %2 could not be read. %3</source>
        <translation>未写入任何内容：%1 到 %2 无法读取。%3</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>未写入任何内容。%1</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was written.</source>
        <translation>已取消，未写入任何内容。</translation>
    </message>
    <message numerus="yes">
        <source>%1 messages</source>
        <translation>
            <numerusform>%1 条消息</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 poses</source>
        <translation>
            <numerusform>%1 个位姿</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2</source>
        <translation>已将 %1 导出到 %2</translation>
    </message>
    <message>
        <source>Messages left out because they have no time stamp or cannot be read: %1.</source>
        <translation>因没有时间戳或无法读取而略去的消息：%1。</translation>
    </message>
    <message>
        <source>The bag was closed before the export finished. Nothing was written.</source>
        <translation>导出完成之前数据包已关闭，未写入任何内容。</translation>
    </message>
    <message>
        <source>The bag is no longer open.</source>
        <translation>数据包已不再打开。</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 项</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RecordDialog</name>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Record on the robot</source>
        <translation>在机器人上录制</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>robot&apos;s default</source>
        <translation>机器人默认</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;Suffix of the name</source>
        <translation>名称后缀(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>时长(&amp;D)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>A suffix may only contain letters from A to Z, digits, - and _.</source>
        <translation>后缀只能包含字母 A 到 Z、数字、- 和 _。</translation>
    </message>
    <message>
        <source>Asking the robot…</source>
        <translation>正在询问机器人…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RecordingController</name>
    <message>
        <source>R&amp;ecord to a file…</source>
        <translation>录制到文件(&amp;E)…</translation>
    </message>
    <message>
        <source>Record what the robot sends to a file; again to stop</source>
        <translation>把机器人发送的内容录制到文件；再按一次停止</translation>
    </message>
    <message>
        <source>Record to a file</source>
        <translation>录制到文件</translation>
    </message>
    <message>
        <source>Recordings (*.mcap)</source>
        <translation>录制文件 (*.mcap)</translation>
    </message>
    <message>
        <source>There is no robot to record from.</source>
        <translation>没有可录制的机器人。</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Recorded to %1</source>
        <translation>已录制到 %1</translation>
    </message>
    <message>
        <source>the connection was lost, times: %1</source>
        <translation>连接断开的次数：%1</translation>
    </message>
    <message>
        <source>, and not restored at the end</source>
        <translation>，结束时仍未恢复</translation>
    </message>
    <message>
        <source>messages lost because the disk or this computer was too slow: %1</source>
        <translation>因磁盘或电脑太慢而丢失的消息：%1</translation>
    </message>
    <message>
        <source>maps, lists or waypoints that could not be loaded: %1</source>
        <translation>未能加载的地图、列表或路径点：%1</translation>
    </message>
    <message>
        <source>The recording has a gap: the connection was lost after %1. %2</source>
        <translation>录制有一段空缺：%1 后连接断开。%2</translation>
    </message>
    <message>
        <source>Reconnected after %1: recording continues.</source>
        <translation>%1 后已重新连接：录制继续。</translation>
    </message>
    <message>
        <source>The robot cannot be reached at the moment.</source>
        <translation>目前无法连接到机器人。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>, lost: %1</source>
        <translation>，丢失：%1</translation>
    </message>
    <message>
        <source>, no connection</source>
        <translation>，没有连接</translation>
    </message>
    <message>
        <source>%1 Recording continues when there is enough disk space.</source>
        <translation>%1有足够的磁盘空间后继续录制。</translation>
    </message>
    <message>
        <source>Recording to the file continues.</source>
        <translation>录制到文件继续进行。</translation>
    </message>
    <message>
        <source>Recorded to %1, but it is incomplete: %2.</source>
        <translation>已录制到 %1，但不完整：%2。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RecordingsController</name>
    <message>
        <source>Reco&amp;rdings…</source>
        <translation>录制文件(&amp;R)…</translation>
    </message>
    <message>
        <source>The robot&apos;s recordings, which can be replayed</source>
        <translation>机器人的录制文件，可以回放</translation>
    </message>
    <message>
        <source>The downloads stopped when the robot was disconnected. Download to the same file again to resume them.</source>
        <translation>机器人断开连接时下载已停止。再次下载到同一文件即可续传。</translation>
    </message>
    <message>
        <source>opening…</source>
        <translation>正在打开…</translation>
    </message>
    <message>
        <source>Download %1</source>
        <translation>下载 %1</translation>
    </message>
    <message>
        <source>downloading…</source>
        <translation>正在下载…</translation>
    </message>
    <message>
        <source>%1 %, %2 of %3</source>
        <translation>%1%，%2 / %3</translation>
    </message>
    <message>
        <source>downloaded to %1</source>
        <translation>已下载到 %1</translation>
    </message>
    <message>
        <source>%1 was downloaded, %2.</source>
        <translation>%1 已下载，%2。</translation>
    </message>
    <message>
        <source>stopped; can be resumed</source>
        <translation>已停止；可以续传</translation>
    </message>
    <message>
        <source>The robot is recording %1.</source>
        <translation>机器人正在录制 %1。</translation>
    </message>
    <message>
        <source>Nothing was recorded: %1</source>
        <translation>没有录制任何内容：%1</translation>
    </message>
    <message>
        <source>Delete from the robot</source>
        <translation>从机器人删除</translation>
    </message>
    <message>
        <source>Delete the %1 %2 (%3) from the robot? This cannot be undone.</source>
        <translation>从机器人删除%1 %2（%3）？此操作无法撤销。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>deleting…</source>
        <translation>正在删除…</translation>
    </message>
    <message>
        <source>not deleted: %1</source>
        <translation>未删除：%1</translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <translation>%1 已删除。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RecordingsDock</name>
    <message>
        <source>Recordings</source>
        <translation>录制文件</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>搜索录制文件</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Download…</source>
        <translation>下载…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Record on the robot…</source>
        <translation>在机器人上录制…</translation>
    </message>
    <message>
        <source>Refresh the list of recordings</source>
        <translation>刷新录制文件列表</translation>
    </message>
    <message>
        <source>Ask the robot for its recordings again</source>
        <translation>重新向机器人询问其录制文件</translation>
    </message>
    <message>
        <source>Connect to a robot to see its recordings.</source>
        <translation>连接机器人以查看其录制文件。</translation>
    </message>
    <message>
        <source>Asking the robot…</source>
        <translation>正在询问机器人…</translation>
    </message>
    <message>
        <source>The robot has no bags or recordings.</source>
        <translation>机器人没有数据包或录制文件。</translation>
    </message>
    <message>
        <source>The list appears as soon as the robot is connected.</source>
        <translation>机器人连接后列表即出现。</translation>
    </message>
    <message>
        <source>No recording matches the search.</source>
        <translation>没有符合搜索的录制文件。</translation>
    </message>
    <message>
        <source>asking the robot…</source>
        <translation>正在询问机器人…</translation>
    </message>
    <message numerus="yes">
        <source>%1 recordings</source>
        <translation>
            <numerusform>%1 个录制文件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>While a bag is replayed, nothing can be changed on the robot.</source>
        <translation>回放数据包期间，不能更改机器人上的任何内容。</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>The robot cannot be reached at the moment.</source>
        <translation>目前无法连接到机器人。</translation>
    </message>
    <message>
        <source>Make the robot record a bag</source>
        <translation>让机器人录制数据包</translation>
    </message>
    <message>
        <source>Copy name</source>
        <translation>复制名称</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>已复制 %1</translation>
    </message>
    <message>
        <source>Copy the error</source>
        <translation>复制错误</translation>
    </message>
    <message>
        <source>Rehearse</source>
        <translation>预演</translation>
    </message>
    <message>
        <source>Find out what its way crosses on the map on screen</source>
        <translation>查看其路径在屏幕上的地图中穿过什么</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RectangleTool</name>
    <message>
        <source>Drag a rectangle over the region to fetch. Esc: back</source>
        <translation>在要获取的分块上拖出矩形。Esc：返回</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ReferenceController</name>
    <message>
        <source>Re&amp;ference map…</source>
        <translation>参考地图(&amp;F)…</translation>
    </message>
    <message>
        <source>Lay a map file under what the robot shows</source>
        <translation>把地图文件铺在机器人显示的内容之下</translation>
    </message>
    <message>
        <source>&amp;Align with another map…</source>
        <translation>与另一张地图对齐(&amp;A)…</translation>
    </message>
    <message>
        <source>Find out where another map lies on the one on screen, and lay it there</source>
        <translation>找出另一张地图在屏幕上地图中的位置，并铺在那里</translation>
    </message>
    <message>
        <source>Move the refere&amp;nce map</source>
        <translation>移动参考地图(&amp;N)</translation>
    </message>
    <message>
        <source>Drag or turn the reference map, or add pairs of points</source>
        <translation>拖动或旋转参考地图，或添加点对</translation>
    </message>
    <message>
        <source>move the reference map</source>
        <translation>移动参考地图</translation>
    </message>
    <message>
        <source>add a pair of points</source>
        <translation>添加一个点对</translation>
    </message>
    <message>
        <source>fit the reference map</source>
        <translation>拟合参考地图</translation>
    </message>
    <message>
        <source>remove all pairs of points</source>
        <translation>移除所有点对</translation>
    </message>
    <message>
        <source>remove a pair of points</source>
        <translation>移除一个点对</translation>
    </message>
    <message>
        <source>Choose a reference map</source>
        <translation>选择参考地图</translation>
    </message>
    <message>
        <source>Choose the map to align with</source>
        <translation>选择要对齐的地图</translation>
    </message>
    <message>
        <source>Maps (*.yaml *.yml *.png *.pgm *.bmp)</source>
        <translation>地图 (*.yaml *.yml *.png *.pgm *.bmp)</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Lay it</source>
        <translation>铺上</translation>
    </message>
    <message>
        <source>The map to align with could not be fetched. %1</source>
        <translation>无法获取要对齐的地图。%1</translation>
    </message>
    <message>
        <source>This is not a map file.</source>
        <translation>这不是地图文件。</translation>
    </message>
    <message>
        <source>The reference map: %1</source>
        <translation>参考地图：%1</translation>
    </message>
    <message>
        <source>Reference map</source>
        <translation>参考地图</translation>
    </message>
    <message>
        <source>There is no reference map.</source>
        <translation>没有参考地图。</translation>
    </message>
    <message>
        <source>The pairs of points align the map by themselves: press Fit again. To align it by the walls, remove all pairs but one.</source>
        <translation>点对本身就能对齐地图：请再按“重新拟合”。要按墙对齐，请只留一个点对，移除其余。</translation>
    </message>
    <message>
        <source>There is no map on screen to align with. Open one first.</source>
        <translation>屏幕上没有可对齐的地图。请先打开一张。</translation>
    </message>
    <message>
        <source>One of the maps, or a point, is not the same any more. Align again.</source>
        <translation>其中一张地图或某个点已改变。请重新对齐。</translation>
    </message>
    <message>
        <source>The reference map was moved meanwhile. Align again.</source>
        <translation>参考地图在此期间被移动。请重新对齐。</translation>
    </message>
    <message>
        <source>align the reference map</source>
        <translation>对齐参考地图</translation>
    </message>
    <message>
        <source>show the second best place</source>
        <translation>显示第二佳位置</translation>
    </message>
    <message>
        <source>show the best place</source>
        <translation>显示最佳位置</translation>
    </message>
    <message>
        <source>Fetching the map…</source>
        <translation>正在获取地图…</translation>
    </message>
    <message>
        <source>Looking for the place by the walls…</source>
        <translation>正在按墙查找位置…</translation>
    </message>
    <message>
        <source>Waiting until both maps are read…</source>
        <translation>正在等待两张地图读取完毕…</translation>
    </message>
    <message>
        <source>%1: score %2</source>
        <translation>%1：得分 %2</translation>
    </message>
    <message>
        <source>The reference map was moved since it was aligned.</source>
        <translation>参考地图对齐之后又被移动过。</translation>
    </message>
    <message>
        <source>The map on screen has changed since then. As it was: %1</source>
        <translation>屏幕上的地图此后已更改。当时的结果：%1</translation>
    </message>
    <message>
        <source>Best candidate</source>
        <translation>最佳候选</translation>
    </message>
    <message>
        <source>Second best</source>
        <translation>第二候选</translation>
    </message>
    <message>
        <source>Overlap: %1</source>
        <translation>重叠：%1</translation>
    </message>
    <message>
        <source>There is no whole map on screen.</source>
        <translation>屏幕上没有整张地图。</translation>
    </message>
    <message>
        <source>No reference map. Choose a plan or an older map of this place, to lay it under the map on screen.</source>
        <translation>没有参考地图。请选择本地点的平面图或旧地图，把它铺在屏幕上的地图下面。</translation>
    </message>
    <message>
        <source>There are %1 pairs of points already, the most that are kept. Remove one first.</source>
        <translation>已有 %1 对点，达到上限。请先移除一对。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ReferenceDock</name>
    <message>
        <source>Reference map</source>
        <translation>参考地图</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose a map file to lay under what the robot shows</source>
        <translation>选择一个地图文件，铺在机器人显示的内容之下</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the reference map; its file stays</source>
        <translation>移除参考地图；其文件保留</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Drag the reference map; with Shift turn it</source>
        <translation>拖动参考地图；按住 Shift 旋转</translation>
    </message>
    <message>
        <source>Add points</source>
        <translation>添加点</translation>
    </message>
    <message>
        <source>Click a point of the reference map, then where it really is</source>
        <translation>单击参考地图上的一点，再单击它的实际位置</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Find out by the walls where the reference map lies on the map on screen. It is laid there only if that is sure.</source>
        <translation>按墙找出参考地图在屏幕上地图中的位置。只有确定时才铺在那里。</translation>
    </message>
    <message>
        <source>Fit again</source>
        <translation>重新拟合</translation>
    </message>
    <message>
        <source>Fit the map to its pairs of points again</source>
        <translation>按点对重新拟合地图</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>移除点</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>全部移除</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Show the best candidate</source>
        <translation>显示最佳候选</translation>
    </message>
    <message>
        <source>Lay the reference map there to look at it</source>
        <translation>把参考地图铺在那里查看</translation>
    </message>
    <message>
        <source>Show the second best</source>
        <translation>显示第二候选</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Walls that are off</source>
        <translation>有偏差的墙</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>滑动对比</translation>
    </message>
    <message>
        <source>No wall is off by more than 10 cm.</source>
        <translation>没有墙的偏差超过 10 cm。</translation>
    </message>
    <message>
        <source>Carry over waypoints…</source>
        <translation>迁移路径点…</translation>
    </message>
    <message>
        <source>Carry over overlays…</source>
        <translation>迁移覆盖物…</translation>
    </message>
    <message>
        <source>Moved along x</source>
        <translation>沿 x 移动</translation>
    </message>
    <message>
        <source>Moved along y</source>
        <translation>沿 y 移动</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Where it is</source>
        <translation>实际位置</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Pairs of points</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>over 10 cm</source>
        <translation>超过 10 cm</translation>
    </message>
    <message>
        <source>over 30 cm</source>
        <translation>超过 30 cm</translation>
    </message>
    <message>
        <source>over 1 m</source>
        <translation>超过 1 m</translation>
    </message>
    <message>
        <source>&amp;x</source>
        <translation>&amp;x</translation>
    </message>
    <message>
        <source>&amp;y</source>
        <translation>&amp;y</translation>
    </message>
    <message>
        <source>&amp;Turned by</source>
        <translation>旋转(&amp;T)</translation>
    </message>
    <message>
        <source>There is no reference map.</source>
        <translation>没有参考地图。</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>How far the walls of the reference map are from one on screen</source>
        <translation>参考地图的墙与屏幕上的墙相距多远</translation>
    </message>
    <message>
        <source>On screen</source>
        <translation>屏幕上</translation>
    </message>
    <message>
        <source>How far the walls of the map on screen are from those of the reference map</source>
        <translation>屏幕上地图的墙与参考地图的墙相距多远</translation>
    </message>
    <message>
        <source>Within 10 cm</source>
        <translation>10 cm 以内</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95% 不超过</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>已比较</translation>
    </message>
    <message>
        <source>Distances to the nearest wall of the other map, where that knows something</source>
        <translation>到另一张地图最近墙的距离，限于该地图已知之处</translation>
    </message>
    <message>
        <source>Two pairs of points or more turn the map, too.</source>
        <translation>两个或更多点对还能旋转地图。</translation>
    </message>
    <message>
        <source>One pair moves the map; a second one turns it, too.</source>
        <translation>一个点对只移动地图；有第二个时还能旋转。</translation>
    </message>
    <message numerus="yes">
        <source>%1 pairs, off by %2 (root mean square)</source>
        <translation>
            <numerusform>%1 个点对，偏差 %2（均方根）</numerusform>
        </translation>
    </message>
    <message>
        <source>Show what differs between the reference map and the map on screen: red is not on the reference map, blue is only there</source>
        <translation>显示参考地图与屏幕上地图的差异：红色为参考地图上没有的，蓝色为只在参考地图上有的</translation>
    </message>
    <message>
        <source>Drag a divider between the map on screen and the reference map as it lies now; Esc ends it</source>
        <translation>在屏幕上的地图与现在所铺的参考地图之间拖动分隔线；Esc 结束</translation>
    </message>
    <message>
        <source>Mark the walls of both maps that are far from those of the other one: a bent corridor is seen by them</source>
        <translation>标出两张地图中与对方的墙相距较远的墙：弯曲的走廊可由此看出</translation>
    </message>
    <message>
        <source>Find out what becomes of the waypoints of the reference map on the map on screen</source>
        <translation>查看参考地图的路径点在屏幕上的地图中会变成什么</translation>
    </message>
    <message>
        <source>Find out what becomes of the overlays of the reference map on the map on screen</source>
        <translation>查看参考地图的覆盖物在屏幕上的地图中会变成什么</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Show that part</source>
        <translation>显示该部分</translation>
    </message>
    <message>
        <source>Look at where its walls lie beside those on screen</source>
        <translation>查看其墙与屏幕上的墙错开的位置</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ReferenceTool</name>
    <message>
        <source>This is not on the reference map. Click one of its points first.</source>
        <translation>这里不在参考地图上。请先单击它的一点。</translation>
    </message>
    <message>
        <source>Drag or use the arrows to move the reference map, Shift+drag or [ and ] to turn it around the middle of the view. Esc leaves.</source>
        <translation>拖动或用方向键移动参考地图，Shift+拖动或 [ 和 ] 绕视图中心旋转。Esc 退出。</translation>
    </message>
    <message>
        <source>Click where this point is on the robot&apos;s map. Esc takes it back.</source>
        <translation>单击该点在机器人地图上的位置。Esc 收回。</translation>
    </message>
    <message>
        <source>Click a point of the reference map, then where it is on the robot&apos;s map. Esc leaves.</source>
        <translation>单击参考地图上的一点，再单击它在机器人地图上的位置。Esc 退出。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RegionTool</name>
    <message>
        <source>Drag from the centre of a sphere to its edge to fetch its cloud. Esc leaves.</source>
        <translation>从球心拖到球面，获取其点云。Esc 退出。</translation>
    </message>
    <message>
        <source>Drag a box to fetch its cloud. Esc leaves.</source>
        <translation>拖出方框，获取其点云。Esc 退出。</translation>
    </message>
    <message>
        <source>Radius %1</source>
        <translation>半径 %1</translation>
    </message>
    <message>
        <source>%1 x %2</source>
        <translation>%1 x %2</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RegionsController</name>
    <message>
        <source>Re&amp;fetch the regions</source>
        <translation>重新获取分块(&amp;F)</translation>
    </message>
    <message>
        <source>Fetch all visible regions again</source>
        <translation>重新获取所有可见的分块</translation>
    </message>
    <message>
        <source>Refetch regions automaticall&amp;y</source>
        <translation>自动重新获取分块(&amp;Y)</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>从不</translation>
    </message>
    <message>
        <source>Every 10 seconds</source>
        <translation>每 10 秒</translation>
    </message>
    <message>
        <source>Every minute</source>
        <translation>每分钟</translation>
    </message>
    <message>
        <source>Every 10 minutes</source>
        <translation>每 10 分钟</translation>
    </message>
    <message>
        <source>Fetch the &amp;whole map…</source>
        <translation>获取整张地图(&amp;W)…</translation>
    </message>
    <message>
        <source>Fetch the robot&apos;s whole map at once</source>
        <translation>一次获取机器人的整张地图</translation>
    </message>
    <message>
        <source>&amp;Save the map on the robot…</source>
        <translation>在机器人上保存地图(&amp;S)…</translation>
    </message>
    <message>
        <source>The robot writes its map to a file on its own disk</source>
        <translation>机器人把地图写入自己磁盘上的文件</translation>
    </message>
    <message>
        <source>Fetch a regi&amp;on…</source>
        <translation>获取一个分块(&amp;O)…</translation>
    </message>
    <message>
        <source>Draw a rectangle to fetch it, then save it or keep it on screen</source>
        <translation>画矩形获取分块，然后保存或保留在屏幕上</translation>
    </message>
    <message>
        <source>The robot no longer sends its map by region. The regions received so far stay.</source>
        <translation>机器人不再按分块发送地图。已收到的分块保留。</translation>
    </message>
    <message>
        <source>Fetch the whole map…</source>
        <translation>获取整张地图…</translation>
    </message>
    <message>
        <source>Fetch a region…</source>
        <translation>获取一个分块…</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RehearsalController</name>
    <message>
        <source>Rehearse a recorded &amp;way…</source>
        <translation>预演录制的路径(&amp;W)…</translation>
    </message>
    <message>
        <source>Find out what a recorded way crosses on the map on screen</source>
        <translation>找出录制的路径在屏幕上的地图中穿过什么</translation>
    </message>
    <message>
        <source>Choose a recorded way</source>
        <translation>选择录制的路径</translation>
    </message>
    <message>
        <source>Recordings and tracks (*.mcap *.bag *.db3 *.csv *.geojson *.json *.tum)</source>
        <translation>录制文件和行驶轨迹 (*.mcap *.bag *.db3 *.csv *.geojson *.json *.tum)</translation>
    </message>
    <message>
        <source>There is no whole map on screen.</source>
        <translation>屏幕上没有整张地图。</translation>
    </message>
    <message>
        <source>The map on screen is still being read.</source>
        <translation>屏幕上的地图仍在读取。</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>This is no recording.</source>
        <translation>这不是录制文件。</translation>
    </message>
    <message>
        <source>Parts of the recording cannot be read.</source>
        <translation>录制文件的部分内容无法读取。</translation>
    </message>
    <message>
        <source>Its end is missing: the recording was interrupted, or is still going on.</source>
        <translation>缺少结尾：录制被中断，或仍在进行。</translation>
    </message>
    <message>
        <source>This is no track. Choose a recording, or a track that was exported.</source>
        <translation>这不是行驶轨迹。请选择录制文件，或导出的行驶轨迹。</translation>
    </message>
    <message>
        <source>It was moved as the reference map lies.</source>
        <translation>它已按参考地图的位置移动。</translation>
    </message>
    <message>
        <source>It lies as it was recorded.</source>
        <translation>它位于录制时的位置。</translation>
    </message>
    <message>
        <source>Choose a recorded way to see what it crosses on this map. If it was driven on an old map, lay and align that as a reference map first.</source>
        <translation>选择录制的路径，查看它在这张地图上穿过什么。如果它是在旧地图上行驶的，请先把旧地图作为参考地图铺上并对齐。</translation>
    </message>
    <message>
        <source>The reference map was moved, or is another one now. Press Again.</source>
        <translation>参考地图被移动过，或已换成另一张。请按“重新预演”。</translation>
    </message>
    <message>
        <source>Cancelled. Press Again.</source>
        <translation>已取消。请按“重新预演”。</translation>
    </message>
    <message>
        <source>The map on screen has changed, or is another one now. Press Again.</source>
        <translation>屏幕上的地图已更改，或已换成另一张。请按“重新预演”。</translation>
    </message>
    <message>
        <source>The robot does not offer its recordings any more.</source>
        <translation>机器人不再提供它的录制文件。</translation>
    </message>
    <message>
        <source>Reading %1: %2 %</source>
        <translation>正在读取 %1：%2%</translation>
    </message>
    <message>
        <source>Looking at what %1 crosses…</source>
        <translation>正在查看 %1 穿过什么…</translation>
    </message>
    <message>
        <source>The map on screen has changed since then. As it was: %1</source>
        <translation>屏幕上的地图此后已更改。当时的结果：%1</translation>
    </message>
    <message>
        <source>Connect to a robot to see its recordings.</source>
        <translation>连接机器人以查看其录制文件。</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>Still shown: %1</source>
        <translation>仍在显示：%1</translation>
    </message>
    <message>
        <source>Parts of the map on screen could not be read.</source>
        <translation>屏幕上的地图有部分无法读取。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RehearsalDock</name>
    <message>
        <source>Rehearse</source>
        <translation>预演</translation>
    </message>
    <message>
        <source>A recording, or a track that was exported</source>
        <translation>录制文件，或导出的行驶轨迹</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>重新预演</translation>
    </message>
    <message>
        <source>Read it again, and lay it on the map as it is now</source>
        <translation>重新读取，并按地图现状铺上</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Take the way off the map</source>
        <translation>从地图上移除该路径</translation>
    </message>
    <message>
        <source>Meets</source>
        <translation>遇到</translation>
    </message>
    <message>
        <source>Length (m)</source>
        <translation>长度 (m)</translation>
    </message>
    <message>
        <source>From (UTC)</source>
        <translation>开始时间 (UTC)</translation>
    </message>
    <message>
        <source>What the way crosses</source>
        <translation>路径穿过的内容</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>On the robot…</source>
        <translation>机器人上的…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop reading the way</source>
        <translation>停止读取该路径</translation>
    </message>
    <message>
        <source>Radius of the robot</source>
        <translation>机器人半径</translation>
    </message>
    <message>
        <source>Radius of the robot: 0 is that of its own footprint</source>
        <translation>机器人半径：0 表示按其自身外形</translation>
    </message>
    <message>
        <source>Lists the robot&apos;s recordings: choose one, then Rehearse</source>
        <translation>列出机器人的录制文件：选择一个，然后点“预演”</translation>
    </message>
    <message>
        <source>Robot: %1 m</source>
        <translation>机器人：%1 m</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RenameDialog</name>
    <message>
        <source>no name is left</source>
        <translation>没有剩余的名称</translation>
    </message>
    <message>
        <source>another waypoint has this name</source>
        <translation>另一路径点已用此名称</translation>
    </message>
    <message>
        <source>several would get this name</source>
        <translation>有多个会得到此名称</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>New name</source>
        <translation>新名称</translation>
    </message>
    <message>
        <source>Re&amp;versed</source>
        <translation>倒序(&amp;V)</translation>
    </message>
    <message>
        <source>Match &amp;case</source>
        <translation>区分大小写(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>Rename waypoints</source>
        <translation>重命名路径点</translation>
    </message>
    <message>
        <source>New names, counted</source>
        <translation>新名称，编号</translation>
    </message>
    <message>
        <source>Replace a part</source>
        <translation>替换一部分</translation>
    </message>
    <message>
        <source>How they are renamed</source>
        <translation>如何重命名</translation>
    </message>
    <message>
        <source>Present and new names</source>
        <translation>现有名称和新名称</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Corridor ##</source>
        <translation>走廊 ##</translation>
    </message>
    <message>
        <source>Pattern of the new names</source>
        <translation>新名称的样式</translation>
    </message>
    <message>
        <source>First number</source>
        <translation>第一个编号</translation>
    </message>
    <message>
        <source>Step from number to number</source>
        <translation>编号的步长</translation>
    </message>
    <message>
        <source>as they are listed</source>
        <translation>按列表顺序</translation>
    </message>
    <message>
        <source>from left to right (x)</source>
        <translation>从左到右 (x)</translation>
    </message>
    <message>
        <source>from bottom to top (y)</source>
        <translation>从下到上 (y)</translation>
    </message>
    <message>
        <source>along their line</source>
        <translation>沿它们所在的线</translation>
    </message>
    <message>
        <source>as they were selected</source>
        <translation>按选择顺序</translation>
    </message>
    <message>
        <source>Order of the numbers</source>
        <translation>编号的顺序</translation>
    </message>
    <message>
        <source># is the number (## with two digits, and so on), * is the present name.</source>
        <translation># 表示编号（## 为两位，依此类推），* 表示现有名称。</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>起始(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;step</source>
        <translation>步长(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Order</source>
        <translation>顺序(&amp;O)</translation>
    </message>
    <message>
        <source>What is replaced</source>
        <translation>要替换的内容</translation>
    </message>
    <message>
        <source>Replacement</source>
        <translation>替换为的内容</translation>
    </message>
    <message>
        <source>nothing: it is removed</source>
        <translation>无：予以移除</translation>
    </message>
    <message>
        <source>F&amp;ind</source>
        <translation>查找(&amp;I)</translation>
    </message>
    <message>
        <source>Replace &amp;by</source>
        <translation>替换为(&amp;B)</translation>
    </message>
    <message numerus="yes">
        <source>%1 names change.</source>
        <translation>
            <numerusform>%1 个名称改变。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 names would not be unique.</source>
        <translation>
            <numerusform>%1 个名称会重复。</numerusform>
        </translation>
    </message>
    <message>
        <source>This robot refuses that.</source>
        <translation>该机器人不接受这样。</translation>
    </message>
    <message numerus="yes">
        <source>%1 names would be empty.</source>
        <translation>
            <numerusform>%1 个名称会为空。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ReplayController</name>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Re&amp;play</source>
        <translation>回放(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Play or pause the bag</source>
        <translation>播放或暂停数据包</translation>
    </message>
    <message>
        <source>&amp;Backwards or forwards</source>
        <translation>倒放或正放(&amp;B)</translation>
    </message>
    <message>
        <source>Reverse the direction</source>
        <translation>反转方向</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>加快(&amp;F)</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>加快播放</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>减慢(&amp;S)</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>减慢播放</translation>
    </message>
    <message>
        <source>Previous &amp;message</source>
        <translation>上一条消息(&amp;M)</translation>
    </message>
    <message>
        <source>To the previous message</source>
        <translation>到上一条消息</translation>
    </message>
    <message>
        <source>Next m&amp;essage</source>
        <translation>下一条消息(&amp;E)</translation>
    </message>
    <message>
        <source>To the next message</source>
        <translation>到下一条消息</translation>
    </message>
    <message>
        <source>Previous e&amp;vent</source>
        <translation>上一个事件(&amp;V)</translation>
    </message>
    <message>
        <source>To the previous event</source>
        <translation>到上一个事件</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>下一个事件(&amp;N)</translation>
    </message>
    <message>
        <source>To the next event</source>
        <translation>到下一个事件</translation>
    </message>
    <message>
        <source>Go to a &amp;time…</source>
        <translation>转到时间(&amp;T)…</translation>
    </message>
    <message>
        <source>Type the time to go to</source>
        <translation>输入要转到的时间</translation>
    </message>
    <message>
        <source>End the &amp;loop</source>
        <translation>结束循环(&amp;L)</translation>
    </message>
    <message>
        <source>Continue playing beyond the loop</source>
        <translation>越过循环继续播放</translation>
    </message>
    <message>
        <source>&amp;Read the whole bag</source>
        <translation>读取整个数据包(&amp;R)</translation>
    </message>
    <message>
        <source>Read to the end to find all events</source>
        <translation>读到结尾以找出所有事件</translation>
    </message>
    <message>
        <source>E&amp;xport a range…</source>
        <translation>导出一段(&amp;X)…</translation>
    </message>
    <message>
        <source>Write a part of the bag or the path of the robot to a file</source>
        <translation>把数据包的一段或机器人的路径写入文件</translation>
    </message>
    <message>
        <source>Report of t&amp;his moment…</source>
        <translation>此刻的报告(&amp;H)…</translation>
    </message>
    <message>
        <source>Write what the robot believed at this time, with map and curves, as one HTML file</source>
        <translation>把机器人此时的判断连同地图和曲线写成一个 HTML 文件</translation>
    </message>
    <message>
        <source>Back to the r&amp;obot</source>
        <translation>回到机器人(&amp;O)</translation>
    </message>
    <message>
        <source>End the replay</source>
        <translation>结束回放</translation>
    </message>
    <message>
        <source>Report of this moment</source>
        <translation>此刻的报告</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>The previous report is still being written.</source>
        <translation>上一份报告仍在写入。</translation>
    </message>
    <message>
        <source>%1 is the recording itself. Choose another name.</source>
        <translation>%1 就是录制文件本身，请另选名称。</translation>
    </message>
    <message>
        <source>The report is being written…</source>
        <translation>正在写报告…</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Save the listed events</source>
        <translation>保存列出的事件</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>正在打开 %1…</translation>
    </message>
    <message>
        <source>%1 cannot be played: %2</source>
        <translation>%1 无法播放：%2</translation>
    </message>
    <message>
        <source>This bag contains no submap list: the whole map is shown.</source>
        <translation>此数据包不含子图列表：显示整张地图。</translation>
    </message>
    <message>
        <source>Close the replay</source>
        <translation>关闭回放</translation>
    </message>
    <message>
        <source>Back to the map</source>
        <translation>回到地图</translation>
    </message>
    <message>
        <source>Back to the robot</source>
        <translation>回到机器人</translation>
    </message>
    <message>
        <source>Replay of %1, not live.</source>
        <translation>正在回放 %1，不是实时。</translation>
    </message>
    <message>
        <source>Replay of %1, not live. The robot is not changed.</source>
        <translation>正在回放 %1，不是实时。不会改变机器人。</translation>
    </message>
    <message>
        <source>The map is the robot&apos;s current one.</source>
        <translation>地图是机器人当前的地图。</translation>
    </message>
    <message>
        <source>The bag contains no map up to this time.</source>
        <translation>到此时间为止，数据包中没有地图。</translation>
    </message>
    <message>
        <source>No connection to the robot since %1: nothing was recorded at this time.</source>
        <translation>自 %1 起没有机器人的连接：此时没有录制任何内容。</translation>
    </message>
    <message>
        <source>The recording was interrupted at %1, or is still going on.</source>
        <translation>录制在 %1 被中断，或仍在进行。</translation>
    </message>
    <message>
        <source>The recording was cut off at %1 and has been repaired.</source>
        <translation>录制文件在 %1 处被截断，已修复。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ReviewModel</name>
    <message>
        <source>not sent: another waypoint is called %1</source>
        <translation>未下发：另一路径点名为 %1</translation>
    </message>
    <message>
        <source>will be refused. %1</source>
        <translation>会被拒绝。%1</translation>
    </message>
    <message>
        <source>may be refused. %1</source>
        <translation>可能被拒绝。%1</translation>
    </message>
    <message>
        <source>cannot be deleted later</source>
        <translation>以后不能删除</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>in progress…</source>
        <translation>进行中…</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>done, answer lost</source>
        <translation>已完成，应答丢失</translation>
    </message>
    <message>
        <source>not sent</source>
        <translation>未下发</translation>
    </message>
    <message>
        <source>failed. %1</source>
        <translation>失败。%1</translation>
    </message>
    <message>
        <source>unknown. %1</source>
        <translation>未知。%1</translation>
    </message>
    <message>
        <source>not sent. %1</source>
        <translation>未下发。%1</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>保存 %1</translation>
    </message>
    <message>
        <source>save the list</source>
        <translation>保存列表</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>调用</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RobotController</name>
    <message>
        <source>Show all %1</source>
        <translation>显示全部 %1</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Show it anyway</source>
        <translation>仍然显示</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>The robot is making a new map, not this one. The robot and its sensor data are hidden.</source>
        <translation>机器人正在建立新地图，不是这张。机器人及其传感器数据已隐藏。</translation>
    </message>
    <message>
        <source>The robot is not in this map. The robot and its sensor data are hidden.</source>
        <translation>机器人不在此地图中。机器人及其传感器数据已隐藏。</translation>
    </message>
    <message>
        <source>The robot is in %1, not in this map. The robot and its sensor data are hidden.</source>
        <translation>机器人在 %1 中，不在此地图中。机器人及其传感器数据已隐藏。</translation>
    </message>
    <message>
        <source>The robot is making a new map, not this one. It is shown anyway.</source>
        <translation>机器人正在建立新地图，不是这张。仍然显示它。</translation>
    </message>
    <message>
        <source>The robot is not in this map. It is shown anyway.</source>
        <translation>机器人不在此地图中。仍然显示它。</translation>
    </message>
    <message>
        <source>The robot is in %1, not in this map. It is shown anyway.</source>
        <translation>机器人在 %1 中，不在此地图中。仍然显示它。</translation>
    </message>
    <message>
        <source>The robot does not report which map it is in. It may not be this one.</source>
        <translation>机器人没有报告它在哪张地图中，可能不是这张。</translation>
    </message>
    <message>
        <source>The robot does not report which map it is in. It is hidden.</source>
        <translation>机器人没有报告它在哪张地图中。已隐藏它。</translation>
    </message>
    <message>
        <source>The robot is making a new map. The overlays of %1 do not belong to it and are hidden.</source>
        <translation>机器人正在建立新地图。%1的覆盖物不属于新地图，已隐藏。</translation>
    </message>
    <message>
        <source>its last map</source>
        <translation>其上一张地图</translation>
    </message>
    <message>
        <source>Show them anyway</source>
        <translation>仍然显示它们</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RobotDock</name>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>No robot connected</source>
        <translation>未连接机器人</translation>
    </message>
    <message>
        <source>Values as of %1, no longer live</source>
        <translation>%1 的数值，已不是实时</translation>
    </message>
    <message>
        <source>This is a file: there is no robot whose state could be shown.</source>
        <translation>这是文件：没有可显示状态的机器人。</translation>
    </message>
    <message>
        <source>, since </source>
        <translation>，始于 </translation>
    </message>
    <message>
        <source>No alerts</source>
        <translation>没有告警</translation>
    </message>
    <message numerus="yes">
        <source>%1 alerts</source>
        <translation>
            <numerusform>%1 个告警</numerusform>
        </translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>及另外 %1 个</translation>
    </message>
    <message>
        <source>%1 %2 %3 since %4</source>
        <translation>%1 %2 %3，始于 %4</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::RobotLookDialog</name>
    <message>
        <source>Colour of the robot</source>
        <translation>机器人的颜色</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>无颜色</translation>
    </message>
    <message>
        <source>Name and colour</source>
        <translation>名称和颜色</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>颜色(&amp;C)</translation>
    </message>
    <message>
        <source>They stay on this computer: nothing changes on the robot.</source>
        <translation>它们只保存在这台电脑上：机器人上没有任何改变。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::Safety</name>
    <message>
        <source>Emergency stop pressed</source>
        <translation>急停已按下</translation>
    </message>
    <message>
        <source>Position lost</source>
        <translation>位置丢失</translation>
    </message>
    <message>
        <source>Wheels released</source>
        <translation>车轮已松开</translation>
    </message>
    <message>
        <source>Under manual control</source>
        <translation>手动控制中</translation>
    </message>
    <message>
        <source>Position uncertain</source>
        <translation>位置不确定</translation>
    </message>
    <message>
        <source>Wheels slipping</source>
        <translation>车轮打滑</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Manual control</source>
        <translation>手动控制</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>%1 since %2</source>
        <translation>%1，始于 %2</translation>
    </message>
    <message>
        <source>%1, on and off, %2 times</source>
        <translation>%1，时有时无，共 %2 次</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>As of %1, no longer live:</source>
        <translation>截至 %1，已不是实时：</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>及另外 %1 个</translation>
    </message>
    <message>
        <source>As of %1: %2</source>
        <translation>截至 %1：%2</translation>
    </message>
    <message>
        <source>Also: %1</source>
        <translation>另有：%1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::SaveMapDialog</name>
    <message>
        <source>Save the map on the robot</source>
        <translation>在机器人上保存地图</translation>
    </message>
    <message>
        <source>The robot writes its map to a file on its own disk. The extension of the name selects the format: most know .png, .pgm or .yaml for grids and .pcd, .ply or .vtk for clouds. An existing file may be replaced.</source>
        <translation>机器人把地图写入自己磁盘上的文件。名称的扩展名决定格式：大多数机器人支持栅格用 .png、.pgm 或 .yaml，点云用 .pcd、.ply 或 .vtk。已有文件可能会被替换。</translation>
    </message>
    <message>
        <source>&amp;Name on the robot</source>
        <translation>机器人上的名称(&amp;N)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>The robot is no longer connected.</source>
        <translation>机器人已断开连接。</translation>
    </message>
    <message>
        <source>The robot saved its map as %1.</source>
        <translation>机器人已把地图保存为 %1。</translation>
    </message>
    <message>
        <source>Waiting for the robot…</source>
        <translation>正在等待机器人…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::SectionDock</name>
    <message>
        <source>Section</source>
        <translation>剖面</translation>
    </message>
    <message>
        <source>&amp;Width of the strip</source>
        <translation>条带宽度(&amp;W)</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Width of the strip</source>
        <translation>条带宽度</translation>
    </message>
    <message>
        <source>Show the whole section (F)</source>
        <translation>显示整个剖面 (F)</translation>
    </message>
    <message>
        <source>The whole section</source>
        <translation>整个剖面</translation>
    </message>
    <message>
        <source>Choose Map &gt; Section and drag a line over a cloud.</source>
        <translation>选择“地图 &gt; 剖面”，在点云上拖一条线。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::SectionTool</name>
    <message>
        <source>Drag a line to see a cross-section of the cloud. Esc leaves.</source>
        <translation>拖一条线，查看点云的剖面。Esc 退出。</translation>
    </message>
    <message>
        <source>%1 long. Drag another line, or press Esc to remove it.</source>
        <translation>长 %1。可拖另一条线，或按 Esc 移除。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::SectionView</name>
    <message>
        <source>Section of the cloud</source>
        <translation>点云的剖面</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::StatusText</name>
    <message>
        <source>%1, %2 x %3 cells</source>
        <translation>%1，%2 x %3 个栅格</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::SubmapTreeModel</name>
    <message>
        <source>Trajectory %1</source>
        <translation>轨迹 %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1: %2, %3 shown, %4 hidden</source>
        <translation>%1：%2，%3 个显示，%4 个隐藏</translation>
    </message>
    <message>
        <source>Centre the map on this submap</source>
        <translation>把地图中心移到此子图</translation>
    </message>
    <message>
        <source>Submap %1, version unknown</source>
        <translation>子图 %1，版本未知</translation>
    </message>
    <message>
        <source>Submap %1, version %2</source>
        <translation>子图 %1，版本 %2</translation>
    </message>
    <message>
        <source>Version %1 is on screen.</source>
        <translation>屏幕上为版本 %1。</translation>
    </message>
    <message>
        <source>Submap</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>标志</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::SwipeHandle</name>
    <message>
        <source>Drag it, or press Left and Right, to reveal one map or the other</source>
        <translation>拖动它，或按左右方向键，显示其中一张地图</translation>
    </message>
    <message>
        <source>Divider between the compared maps</source>
        <translation>所比较地图之间的分隔线</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::TimelineDock</name>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>上一个事件</translation>
    </message>
    <message>
        <source>To the previous event (Page up)</source>
        <translation>到上一个事件 (Page up)</translation>
    </message>
    <message>
        <source>Previous message</source>
        <translation>上一条消息</translation>
    </message>
    <message>
        <source>To the previous message (,)</source>
        <translation>到上一条消息 (,)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Next message</source>
        <translation>下一条消息</translation>
    </message>
    <message>
        <source>To the next message (.)</source>
        <translation>到下一条消息 (.)</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>下一个事件</translation>
    </message>
    <message>
        <source>To the next event (Page down)</source>
        <translation>到下一个事件 (Page down)</translation>
    </message>
    <message>
        <source>Kinds of events</source>
        <translation>事件类型</translation>
    </message>
    <message>
        <source>List of events</source>
        <translation>事件列表</translation>
    </message>
    <message>
        <source>List the events of the bag</source>
        <translation>列出数据包的事件</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>倍速</translation>
    </message>
    <message>
        <source>Playback speed, 0.1x to 20x; negative plays backwards</source>
        <translation>播放倍速，0.1x 到 20x；负值为倒放</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>The time (UTC). Type a time and press Enter to go there, Ctrl+Enter to play until then:
14:36:17.5, 2023-10-31 14:36:17, +1:30 after the start, -10 before the end</source>
        <translation>时间 (UTC)。输入时间后按 Enter 转到那里，按 Ctrl+Enter 播放到那时：
14:36:17.5、2023-10-31 14:36:17、+1:30 表示开始之后、-10 表示结束之前</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Which events to mark on the timeline</source>
        <translation>在时间轴上标出哪些事件</translation>
    </message>
    <message>
        <source>Hidden kinds of events: %1</source>
        <translation>隐藏的事件类型：%1</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>转到 %1</translation>
    </message>
    <message>
        <source>Play until %1</source>
        <translation>播放到 %1</translation>
    </message>
    <message>
        <source>Loop from here to %1</source>
        <translation>从这里循环到 %1</translation>
    </message>
    <message>
        <source>End the loop</source>
        <translation>结束循环</translation>
    </message>
    <message>
        <source>Export the loop…</source>
        <translation>导出循环段…</translation>
    </message>
    <message>
        <source>Export a range…</source>
        <translation>导出一段…</translation>
    </message>
    <message>
        <source>Show the whole bag</source>
        <translation>显示整个数据包</translation>
    </message>
    <message>
        <source>Bags opened in the Recordings panel are played here.</source>
        <translation>在“录制文件”面板中打开的数据包在这里播放。</translation>
    </message>
    <message>
        <source>This bag contains no messages.</source>
        <translation>此数据包不含消息。</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>暂停（空格）</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>播放（空格）</translation>
    </message>
    <message>
        <source>buffering…</source>
        <translation>正在缓冲…</translation>
    </message>
    <message>
        <source>a gap at %1</source>
        <translation>%1 处有空缺</translation>
    </message>
    <message>
        <source>reading earlier data: %1 %</source>
        <translation>正在读取更早的数据：%1%</translation>
    </message>
    <message>
        <source>reading earlier data…</source>
        <translation>正在读取更早的数据…</translation>
    </message>
    <message>
        <source>This is not a time between %1 and %2.</source>
        <translation>这不是 %1 与 %2 之间的时间。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::TimelineView</name>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>及另外 %1 个</translation>
    </message>
    <message>
        <source>%1 to %2 could not be read: %3</source>
        <translation>%1 到 %2 无法读取：%3</translation>
    </message>
    <message>
        <source>Nothing was recorded from %1 to %2 (%3).</source>
        <translation>%1 到 %2 没有录制任何内容（%3）。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ToastStack</name>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1（%2 次）</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ToolBar</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>更多工具</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::TopicsModel</name>
    <message>
        <source>(without a topic)</source>
        <translation>（没有话题）</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>binary</source>
        <translation>二进制</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Over the last 5 seconds</source>
        <translation>最近 5 秒内</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>话题</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Bytes/s</source>
        <translation>字节/s</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>最近</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::TransferController</name>
    <message>
        <source>&amp;Add a downloaded map…</source>
        <translation>添加下载的地图(&amp;A)…</translation>
    </message>
    <message>
        <source>Add a map that was downloaded from a robot to this robot&apos;s maps</source>
        <translation>把从机器人下载的地图添加到该机器人的地图</translation>
    </message>
    <message>
        <source>Choose the folder of a downloaded map</source>
        <translation>选择下载的地图的文件夹</translation>
    </message>
    <message>
        <source>Add a map from a p&amp;icture…</source>
        <translation>由图像添加地图(&amp;I)…</translation>
    </message>
    <message>
        <source>Make a map from a PNG and add it to this robot&apos;s maps</source>
        <translation>由 PNG 生成地图，并添加到该机器人的地图</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>选择图像</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>The transfer stopped when the robot was disconnected. Start a download again to resume it.</source>
        <translation>机器人断开连接时传输已停止。再次开始下载即可续传。</translation>
    </message>
    <message>
        <source>Download with its data…</source>
        <translation>连同数据下载…</translation>
    </message>
    <message>
        <source>Download and open its submaps…</source>
        <translation>下载并打开其子图…</translation>
    </message>
    <message>
        <source>Shows the SLAM state of this map from the downloaded file, without the robot</source>
        <translation>由下载的文件显示此地图的 SLAM 状态，不需要机器人</translation>
    </message>
    <message>
        <source>Choose where to create the folder of %1</source>
        <translation>选择在哪里创建 %1 的文件夹</translation>
    </message>
    <message>
        <source>Download a map</source>
        <translation>下载地图</translation>
    </message>
    <message>
        <source>%1 goes to %2</source>
        <translation>%1 将存到 %2</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>%1 was downloaded to %2, %3.</source>
        <translation>%1 已下载到 %2，%3。</translation>
    </message>
    <message>
        <source>%1 was downloaded to %2 without data: the robot has none for it.</source>
        <translation>%1 已下载到 %2，不含数据：机器人没有它的数据。</translation>
    </message>
    <message>
        <source>Add a downloaded map</source>
        <translation>添加下载的地图</translation>
    </message>
    <message>
        <source>Sending %1 to the robot</source>
        <translation>正在把 %1 下发到机器人</translation>
    </message>
    <message>
        <source>%1 cannot be a map: %2</source>
        <translation>%1 不能作为地图：%2</translation>
    </message>
    <message>
        <source>A map from a picture</source>
        <translation>由图像生成地图</translation>
    </message>
    <message>
        <source>Add as another map</source>
        <translation>作为另一张地图添加</translation>
    </message>
    <message>
        <source>%1 was added to the robot&apos;s maps.</source>
        <translation>%1 已添加到机器人的地图。</translation>
    </message>
    <message>
        <source>The robot accepted %1, but stored it differently: %2.</source>
        <translation>机器人已接受 %1，但存储的内容不同：%2。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::TransferDialog</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Asking the robot…</source>
        <translation>正在询问机器人…</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>正在取消…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::UnsavedChanges</name>
    <message>
        <source>Fetched and not saved</source>
        <translation>已获取但未保存</translation>
    </message>
    <message>
        <source>The following was fetched from this robot and is not saved. It will be lost: %1.</source>
        <translation>以下内容从该机器人获取，尚未保存，将会丢失：%1。</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::ViewController</name>
    <message>
        <source>&amp;Pan</source>
        <translation>平移(&amp;P)</translation>
    </message>
    <message>
        <source>Tool: Pan</source>
        <translation>工具：平移</translation>
    </message>
    <message>
        <source>Drag the map</source>
        <translation>拖动地图</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>Tool: Measure</source>
        <translation>工具：测量</translation>
    </message>
    <message>
        <source>Measure distances between clicked points</source>
        <translation>测量所单击各点之间的距离</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>从这里测量</translation>
    </message>
    <message>
        <source>Follow the &amp;robot</source>
        <translation>跟随机器人(&amp;R)</translation>
    </message>
    <message>
        <source>Keep the robot in the centre; panning stops it</source>
        <translation>使机器人保持在中央；平移则停止跟随</translation>
    </message>
    <message>
        <source>&amp;Go to coordinates…</source>
        <translation>转到坐标(&amp;G)…</translation>
    </message>
    <message>
        <source>Centre the map on given coordinates</source>
        <translation>把地图中心移到给定坐标</translation>
    </message>
    <message>
        <source>Rotate as on the robot&apos;s d&amp;isplay</source>
        <translation>按机器人显示屏旋转(&amp;I)</translation>
    </message>
    <message>
        <source>Rotate the view as on the robot&apos;s own display</source>
        <translation>把视图旋转成与机器人自身显示屏一致</translation>
    </message>
    <message>
        <source>Copy &amp;coordinates</source>
        <translation>复制坐标(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the world coordinates under the cursor</source>
        <translation>复制光标下的世界坐标</translation>
    </message>
    <message>
        <source>&amp;Buttons on the map</source>
        <translation>地图上的按钮(&amp;B)</translation>
    </message>
    <message>
        <source>Show the buttons on the map</source>
        <translation>显示地图上的按钮</translation>
    </message>
    <message>
        <source>Show the buttons on top of the map</source>
        <translation>在地图之上显示按钮</translation>
    </message>
    <message>
        <source>Focus the &amp;map</source>
        <translation>聚焦地图(&amp;M)</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the map</source>
        <translation>把键盘焦点移到地图</translation>
    </message>
    <message>
        <source>Focus the ne&amp;xt part of the window</source>
        <translation>聚焦窗口的下一部分(&amp;X)</translation>
    </message>
    <message>
        <source>Move the keyboard focus on: map, strips, panels, status bar, tool bar</source>
        <translation>键盘焦点前移：地图、横条、面板、状态栏、工具栏</translation>
    </message>
    <message>
        <source>Focus the pre&amp;vious part of the window</source>
        <translation>聚焦窗口的上一部分(&amp;V)</translation>
    </message>
    <message>
        <source>Move the keyboard focus back: tool bar, status bar, panels, strips, map</source>
        <translation>键盘焦点后移：工具栏、状态栏、面板、横条、地图</translation>
    </message>
    <message>
        <source>Copy coordinates</source>
        <translation>复制坐标</translation>
    </message>
    <message>
        <source>Centre here</source>
        <translation>中心移到这里</translation>
    </message>
    <message>
        <source>This is a file: there is no robot to follow.</source>
        <translation>这是文件：没有可跟随的机器人。</translation>
    </message>
    <message>
        <source>The robot is not in this map. The view will follow it again in its own map.</source>
        <translation>机器人不在此地图中。它回到自己的地图后，视图会继续跟随。</translation>
    </message>
    <message>
        <source>The robot has not reported its pose yet. The view will follow it as soon as it does.</source>
        <translation>机器人尚未报告其位姿。一旦报告，视图就会跟随。</translation>
    </message>
    <message>
        <source>The open map has no rotation of its own.</source>
        <translation>打开的地图没有自己的旋转角度。</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>已复制 %1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointArranging</name>
    <message>
        <source>&amp;Arrange waypoints</source>
        <translation>排列路径点(&amp;A)</translation>
    </message>
    <message>
        <source>Align on one &amp;x</source>
        <translation>对齐到同一 x(&amp;X)</translation>
    </message>
    <message>
        <source>Move all selected waypoints to the middle of their x</source>
        <translation>把所有选中的路径点移到其 x 的中间</translation>
    </message>
    <message>
        <source>align %1</source>
        <translation>对齐 %1</translation>
    </message>
    <message>
        <source>Align on one &amp;y</source>
        <translation>对齐到同一 y(&amp;Y)</translation>
    </message>
    <message>
        <source>Move all selected waypoints to the middle of their y</source>
        <translation>把所有选中的路径点移到其 y 的中间</translation>
    </message>
    <message>
        <source>Space the selected waypoints evenly between the outermost two</source>
        <translation>在最外侧两个之间等距排列选中的路径点</translation>
    </message>
    <message>
        <source>&amp;Distribute along x</source>
        <translation>沿 x 均匀分布(&amp;D)</translation>
    </message>
    <message>
        <source>distribute %1</source>
        <translation>均匀分布 %1</translation>
    </message>
    <message>
        <source>Dis&amp;tribute along y</source>
        <translation>沿 y 均匀分布(&amp;T)</translation>
    </message>
    <message>
        <source>Mirror &amp;left and right</source>
        <translation>左右镜像(&amp;L)</translation>
    </message>
    <message>
        <source>Mirror the selected waypoints, with their headings, about the vertical line through their middle</source>
        <translation>以过中心的竖线镜像选中的路径点及其朝向</translation>
    </message>
    <message>
        <source>mirror %1</source>
        <translation>镜像 %1</translation>
    </message>
    <message>
        <source>Mirror &amp;up and down</source>
        <translation>上下镜像(&amp;U)</translation>
    </message>
    <message>
        <source>Mirror the selected waypoints, with their headings, about the horizontal line through their middle</source>
        <translation>以过中心的横线镜像选中的路径点及其朝向</translation>
    </message>
    <message>
        <source>Mirror about a l&amp;ine</source>
        <translation>以一条线镜像(&amp;I)</translation>
    </message>
    <message>
        <source>Mirror the selected waypoints, with their headings, about a line that you draw</source>
        <translation>以您画的线镜像选中的路径点及其朝向</translation>
    </message>
    <message>
        <source>Head towards the &amp;next</source>
        <translation>朝向下一个(&amp;N)</translation>
    </message>
    <message>
        <source>Turn each selected waypoint towards the next one, in the order of selection; the last one like the one before</source>
        <translation>按选择顺序，使每个选中的路径点朝向下一个；最后一个与前一个朝向相同</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>Head around a l&amp;oop</source>
        <translation>沿环路朝向(&amp;O)</translation>
    </message>
    <message>
        <source>Turn each selected waypoint towards the next one, in the order of selection; the last one towards the first</source>
        <translation>按选择顺序，使每个选中的路径点朝向下一个；最后一个朝向第一个</translation>
    </message>
    <message>
        <source>&amp;Rename waypoints…</source>
        <translation>重命名路径点(&amp;R)…</translation>
    </message>
    <message>
        <source>New names for all selected waypoints: counted, or with a part replaced</source>
        <translation>为所有选中的路径点取新名称：编号，或替换其中一部分</translation>
    </message>
    <message>
        <source>Open a map to place waypoints in it.</source>
        <translation>打开一张地图，在其中放置路径点。</translation>
    </message>
    <message>
        <source>Select at least three waypoints.</source>
        <translation>请至少选择三个路径点。</translation>
    </message>
    <message>
        <source>Select at least two waypoints.</source>
        <translation>请至少选择两个路径点。</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>没有选中任何内容。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointCarrying</name>
    <message>
        <source>Carry over waypoints</source>
        <translation>迁移路径点</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>What becomes of the waypoints</source>
        <translation>路径点会变成什么</translation>
    </message>
    <message>
        <source>It is a waypoint of the map on screen now.</source>
        <translation>它现已是屏幕上地图的路径点。</translation>
    </message>
    <message>
        <source>The map on screen has a waypoint of this name. It stays as it is there.</source>
        <translation>屏幕上的地图已有同名路径点，在那里保持不变。</translation>
    </message>
    <message>
        <source>Looking at the walls around each waypoint…</source>
        <translation>正在查看每个路径点周围的墙…</translation>
    </message>
    <message>
        <source>Lay the old map under this one as a reference map, and align it. Then press Carry over waypoints… there.</source>
        <translation>把旧地图作为参考地图铺在这张地图下并对齐，然后在那里按“迁移路径点…”。</translation>
    </message>
    <message>
        <source>The reference map has no waypoints.</source>
        <translation>参考地图没有路径点。</translation>
    </message>
    <message>
        <source>The waypoints of the map on screen cannot be edited.</source>
        <translation>屏幕上地图的路径点不能编辑。</translation>
    </message>
    <message>
        <source>The waypoints of the reference map cannot be read. %1</source>
        <translation>无法读取参考地图的路径点。%1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointEditing</name>
    <message>
        <source>It is stored on the robot, so it was not undone. %1</source>
        <translation>它存储在机器人上，因此没有撤销。%1</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>restore %1</source>
        <translation>恢复 %1</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>移动 %1</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointForm</name>
    <message>
        <source>x of the waypoint</source>
        <translation>路径点的 x</translation>
    </message>
    <message>
        <source>y of the waypoint</source>
        <translation>路径点的 y</translation>
    </message>
    <message>
        <source>Heading of the waypoint</source>
        <translation>路径点的朝向</translation>
    </message>
    <message>
        <source>Name of the waypoint</source>
        <translation>路径点的名称</translation>
    </message>
    <message>
        <source>Tags of the waypoint</source>
        <translation>路径点的标签</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>用逗号分隔</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Counter-clockwise from the x axis of the map</source>
        <translation>从地图 x 轴起逆时针</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>x, y</source>
        <translation>x, y</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>tag %1</source>
        <translation>为 %1 添加标签</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointPlacing</name>
    <message>
        <source>S&amp;nap to</source>
        <translation>吸附到(&amp;N)</translation>
    </message>
    <message>
        <source>Next &amp;warning</source>
        <translation>下一个警告(&amp;W)</translation>
    </message>
    <message>
        <source>The next waypoint with a warning</source>
        <translation>下一个有警告的路径点</translation>
    </message>
    <message>
        <source>&amp;Snap</source>
        <translation>吸附(&amp;S)</translation>
    </message>
    <message>
        <source>Snap waypoints</source>
        <translation>吸附路径点</translation>
    </message>
    <message>
        <source>Placed waypoints snap to what is selected below; Alt suspends it</source>
        <translation>放置的路径点会吸附到下面所选的对象；按住 Alt 暂停吸附</translation>
    </message>
    <message>
        <source>Other &amp;waypoints</source>
        <translation>其他路径点(&amp;W)</translation>
    </message>
    <message>
        <source>The positions of other waypoints, and lines through them</source>
        <translation>其他路径点的位置，以及经过它们的线</translation>
    </message>
    <message>
        <source>A &amp;grid</source>
        <translation>网格(&amp;G)</translation>
    </message>
    <message>
        <source>Lines at a regular distance, see Distances</source>
        <translation>等距的线，见“距离”</translation>
    </message>
    <message>
        <source>A distance to wa&amp;lls</source>
        <translation>与墙的距离(&amp;L)</translation>
    </message>
    <message>
        <source>Positions at a given distance from the nearest wall, see Distances</source>
        <translation>与最近的墙相距给定距离的位置，见“距离”</translation>
    </message>
    <message>
        <source>&amp;Headings of 15°</source>
        <translation>15° 的朝向(&amp;H)</translation>
    </message>
    <message>
        <source>Headings that are multiples of 15°</source>
        <translation>15° 整数倍的朝向</translation>
    </message>
    <message>
        <source>&amp;Distances…</source>
        <translation>距离(&amp;D)…</translation>
    </message>
    <message>
        <source>Grid spacing, distance to walls, and robot size</source>
        <translation>网格间距、与墙的距离和机器人大小</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointReview</name>
    <message>
        <source>Continue if one fails</source>
        <translation>某项失败时继续</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>下发(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Review and send</source>
        <translation>核对并下发</translation>
    </message>
    <message>
        <source>The requests in their order</source>
        <translation>按顺序的请求</translation>
    </message>
    <message>
        <source>Waypoints of %1: %2 in this order.</source>
        <translation>%1 的路径点：按此顺序 %2。</translation>
    </message>
    <message numerus="yes">
        <source>%1 requests</source>
        <translation>
            <numerusform>%1 个请求</numerusform>
        </translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>正在下发…</translation>
    </message>
    <message>
        <source>&amp;Send the rest</source>
        <translation>下发其余(&amp;S)</translation>
    </message>
    <message>
        <source>%1 changed here and elsewhere. Choose which version to keep in the Waypoints panel: nothing is sent before that.</source>
        <translation>%1在这里和别处都被更改。请在“路径点”面板中选择保留哪个版本：在此之前不会下发任何内容。</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>没有下发任何内容。</translation>
    </message>
    <message>
        <source>Nothing was sent: the list has changed in the meantime. These are the requests that are needed now. Review them and send them.</source>
        <translation>没有下发任何内容：列表在此期间已改变。这些是现在需要的请求，请核对后下发。</translation>
    </message>
    <message>
        <source>Nothing has been sent yet.</source>
        <translation>尚未下发任何内容。</translation>
    </message>
    <message>
        <source>There is nothing to send.</source>
        <translation>没有可下发的内容。</translation>
    </message>
    <message>
        <source>Checking the waypoints on the robot…</source>
        <translation>正在检查机器人上的路径点…</translation>
    </message>
    <message>
        <source>Sending: %1 of %2 done.</source>
        <translation>正在下发：已完成 %1 / %2。</translation>
    </message>
    <message>
        <source>Everything was sent. Checking the result…</source>
        <translation>已全部下发。正在检查结果…</translation>
    </message>
    <message>
        <source>All requests that were sent succeeded.</source>
        <translation>下发的请求全部成功。</translation>
    </message>
    <message>
        <source>Of %1 requests: %2 succeeded, %3 failed, %4 with unknown result, %5 not sent.</source>
        <translation>%1 个请求中：%2 个成功，%3 个失败，%4 个结果未知，%5 个未下发。</translation>
    </message>
    <message>
        <source>Every waypoint has a heading on this robot: new ones get 0° until you turn them.</source>
        <translation>该机器人上每个路径点都有朝向：新路径点在您旋转之前为 0°。</translation>
    </message>
    <message>
        <source>Not compared with the robot&apos;s waypoints yet: they could not be read. This happens as soon as the connection is back.</source>
        <translation>尚未与机器人的路径点比较：无法读取它们。连接恢复后会立即比较。</translation>
    </message>
    <message>
        <source>Compared with the robot&apos;s waypoints: all %1 as intended.</source>
        <translation>已与机器人的路径点比较：全部 %1 个符合预期。</translation>
    </message>
    <message>
        <source>Compared with the robot&apos;s waypoints: %1 as intended, %2 differ: %3.</source>
        <translation>已与机器人的路径点比较：%1 个符合预期，%2 个不同：%3。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointTool</name>
    <message>
        <source>move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>There is no waypoint list here. Esc leaves.</source>
        <translation>这里没有路径点列表。Esc 退出。</translation>
    </message>
    <message>
        <source>%1 in the frame. Esc cancels.</source>
        <translation>框内有 %1。Esc 取消。</translation>
    </message>
    <message>
        <source>Turned by %1. Shift turns by 15°, Esc cancels.</source>
        <translation>已旋转 %1。按住 Shift 以 15° 步进旋转，Esc 取消。</translation>
    </message>
    <message>
        <source>Heading %1. Shift turns by 15°, Esc cancels.</source>
        <translation>朝向 %1。按住 Shift 以 15° 步进旋转，Esc 取消。</translation>
    </message>
    <message>
        <source>%1, %2 m. Ctrl: snap to the grid, Alt: no snapping, Esc cancels.</source>
        <translation>%1，%2 m。Ctrl：吸附到网格，Alt：不吸附，Esc 取消。</translation>
    </message>
    <message>
        <source>Click to add a waypoint, drag to move one, Shift and drag to select several. Esc leaves.</source>
        <translation>单击添加路径点，拖动以移动，按住 Shift 拖动可选择多个。Esc 退出。</translation>
    </message>
    <message>
        <source>%1: drag or use the arrows to move, drag the handle to turn, F2 renames, Delete deletes. Esc deselects.</source>
        <translation>%1：拖动或用方向键移动，拖动手柄旋转，F2 重命名，Delete 删除。Esc 取消选择。</translation>
    </message>
    <message>
        <source>%1: drag or use the arrows to move, drag the handle to turn, F2 renames. Esc deselects.</source>
        <translation>%1：拖动或用方向键移动，拖动手柄旋转，F2 重命名。Esc 取消选择。</translation>
    </message>
    <message>
        <source>Drag or use the arrows to move, F2 renames, Delete deletes. Esc deselects.</source>
        <translation>拖动或用方向键移动，F2 重命名，Delete 删除。Esc 取消选择。</translation>
    </message>
    <message>
        <source>Drag or use the arrows to move, F2 renames. Esc deselects.</source>
        <translation>拖动或用方向键移动，F2 重命名。Esc 取消选择。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointTransfer</name>
    <message>
        <source>&amp;Copy waypoints</source>
        <translation>复制路径点(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selection, for another map or a spreadsheet</source>
        <translation>复制选中项，供另一张地图或电子表格使用</translation>
    </message>
    <message>
        <source>&amp;Paste waypoints</source>
        <translation>粘贴路径点(&amp;P)</translation>
    </message>
    <message>
        <source>Paste waypoints copied here, or rows of a spreadsheet</source>
        <translation>粘贴在这里复制的路径点，或电子表格的行</translation>
    </message>
    <message>
        <source>&amp;Import waypoints…</source>
        <translation>导入路径点(&amp;I)…</translation>
    </message>
    <message>
        <source>From a GeoJSON, CSV or YAML file, with a preview of the changes</source>
        <translation>从 GeoJSON、CSV 或 YAML 文件导入，可预览更改</translation>
    </message>
    <message>
        <source>Import waypoints</source>
        <translation>导入路径点</translation>
    </message>
    <message>
        <source>Waypoints (*.geojson *.json *.csv *.tsv *.txt *.yaml *.yml)</source>
        <translation>路径点 (*.geojson *.json *.csv *.tsv *.txt *.yaml *.yml)</translation>
    </message>
    <message>
        <source>E&amp;xport waypoints…</source>
        <translation>导出路径点(&amp;X)…</translation>
    </message>
    <message>
        <source>All waypoints of this map as GeoJSON or CSV, including unsaved changes</source>
        <translation>把此地图的所有路径点导出为 GeoJSON 或 CSV，包括未保存的更改</translation>
    </message>
    <message>
        <source>Export waypoints</source>
        <translation>导出路径点</translation>
    </message>
    <message>
        <source>GeoJSON (*.geojson);;CSV (*.csv)</source>
        <translation>GeoJSON (*.geojson);;CSV (*.csv)</translation>
    </message>
    <message>
        <source>%1 copied</source>
        <translation>已复制 %1</translation>
    </message>
    <message>
        <source>The clipboard contains no waypoints and no table. Copy rows of a spreadsheet first.</source>
        <translation>剪贴板中没有路径点也没有表格。请先复制电子表格的行。</translation>
    </message>
    <message>
        <source>The clipboard cannot be pasted. %1</source>
        <translation>剪贴板的内容无法粘贴。%1</translation>
    </message>
    <message>
        <source>paste %1</source>
        <translation>粘贴 %1</translation>
    </message>
    <message>
        <source>%1 pasted</source>
        <translation>已粘贴 %1</translation>
    </message>
    <message>
        <source>carry over %1</source>
        <translation>迁移 %1</translation>
    </message>
    <message>
        <source>%1 carried over. Nothing has been sent or saved yet.</source>
        <translation>已迁移 %1。尚未下发或保存任何内容。</translation>
    </message>
    <message>
        <source>Nothing was carried over. %1</source>
        <translation>没有迁移任何内容。%1</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 无法读取：%2。</translation>
    </message>
    <message>
        <source>%1 is larger than 64 MiB.</source>
        <translation>%1 大于 64 MiB。</translation>
    </message>
    <message>
        <source>import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>%1 written to %2</source>
        <translation>%1 已写入 %2</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::Waypoints</name>
    <message>
        <source>deleted</source>
        <translation>已删除</translation>
    </message>
    <message>
        <source>name “%1”</source>
        <translation>名称“%1”</translation>
    </message>
    <message>
        <source>position %1, %2 m</source>
        <translation>位置 %1, %2 m</translation>
    </message>
    <message>
        <source>heading %1</source>
        <translation>朝向 %1</translation>
    </message>
    <message>
        <source>no heading</source>
        <translation>无朝向</translation>
    </message>
    <message>
        <source>no tags</source>
        <translation>没有标签</translation>
    </message>
    <message>
        <source>tags %1</source>
        <translation>标签 %1</translation>
    </message>
    <message>
        <source>type %1</source>
        <translation>类型 %1</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>未改变</translation>
    </message>
    <message numerus="yes">
        <source>%1 waypoints</source>
        <translation>
            <numerusform>%1 个路径点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 changes</source>
        <translation>
            <numerusform>%1 处更改</numerusform>
        </translation>
    </message>
    <message>
        <source>Changed here and elsewhere: choose which version to keep.</source>
        <translation>在这里和别处都被更改：请选择保留哪个版本。</translation>
    </message>
    <message>
        <source>Sent, not confirmed yet.</source>
        <translation>已下发，尚未确认。</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>尚未保存。</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>renamed</source>
        <translation>已重命名</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>已移动</translation>
    </message>
    <message>
        <source>retagged</source>
        <translation>已更改标签</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>尚未保存：%1。</translation>
    </message>
    <message>
        <source>new: %1</source>
        <translation>新增：%1</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Here: %1. Elsewhere: %2.</source>
        <translation>这里：%1。别处：%2。</translation>
    </message>
    <message>
        <source>Whether it was saved is unknown. %1</source>
        <translation>不知道是否已保存。%1</translation>
    </message>
    <message>
        <source>Not saved. %1</source>
        <translation>未保存。%1</translation>
    </message>
    <message>
        <source>Not everything was saved: %1 of %2 requests succeeded</source>
        <translation>没有全部保存：%2 个请求中 %1 个成功</translation>
    </message>
    <message>
        <source>, the result of %1 is unknown</source>
        <translation>，%1 个的结果未知</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a temporary name left by an interrupted swap of names. When the rest is sent, it will be called &quot;%2&quot;.</source>
        <translation>“%1”是交换名称被中断后留下的临时名称。其余内容下发后，它将名为“%2”。</translation>
    </message>
    <message>
        <source>Send the rest</source>
        <translation>下发其余</translation>
    </message>
    <message>
        <source>&quot;%1&quot; looks like a temporary name left by an interrupted swap of names. It was called &quot;%2&quot; before.</source>
        <translation>“%1”看起来是交换名称被中断后留下的临时名称。它原名“%2”。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; looks like a temporary name left by an interrupted swap of names. Another waypoint is called &quot;%2&quot; now.</source>
        <translation>“%1”看起来是交换名称被中断后留下的临时名称。现在另一路径点名为“%2”。</translation>
    </message>
    <message>
        <source>Rename back</source>
        <translation>改回原名</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointsController</name>
    <message>
        <source>&amp;Waypoints</source>
        <translation>路径点(&amp;W)</translation>
    </message>
    <message>
        <source>Tool: Waypoints</source>
        <translation>工具：路径点</translation>
    </message>
    <message>
        <source>Add, move, turn and rename waypoints on the map</source>
        <translation>在地图上添加、移动、旋转和重命名路径点</translation>
    </message>
    <message>
        <source>Add &amp;waypoint here</source>
        <translation>在此处添加路径点(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Discard changes to waypoints…</source>
        <translation>放弃路径点的更改(&amp;D)…</translation>
    </message>
    <message>
        <source>Restore the waypoints as last saved</source>
        <translation>恢复为上次保存的路径点</translation>
    </message>
    <message>
        <source>Re&amp;name %1…</source>
        <translation>重命名 %1(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Delete %1</source>
        <translation>删除 %1(&amp;D)</translation>
    </message>
    <message>
        <source>There is no connection to the robot, so nothing can be sent at present.</source>
        <translation>没有与机器人的连接，目前无法下发任何内容。</translation>
    </message>
    <message>
        <source>The unsaved waypoints of %1 are kept as a draft.</source>
        <translation>%1 未保存的路径点已留作草稿。</translation>
    </message>
    <message>
        <source>Waypoints of %1 saved</source>
        <translation>%1 的路径点已保存</translation>
    </message>
    <message>
        <source>Waypoints: %1</source>
        <translation>路径点：%1</translation>
    </message>
    <message>
        <source>Open a map file (Ctrl+Shift+O) to see and edit its waypoints.</source>
        <translation>打开地图文件 (Ctrl+Shift+O) 以查看和编辑其路径点。</translation>
    </message>
    <message>
        <source>Waypoints belong to a whole map. Open one in the Maps panel.</source>
        <translation>路径点属于整张地图。请在“地图”面板中打开一张。</translation>
    </message>
    <message>
        <source>Loading the waypoints.</source>
        <translation>正在加载路径点。</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard draft</source>
        <translation>放弃草稿</translation>
    </message>
    <message>
        <source>%1 changed here and elsewhere. Choose which version to keep before saving.</source>
        <translation>%1在这里和别处都被更改。保存之前请选择保留哪个版本。</translation>
    </message>
    <message>
        <source>Keep the name</source>
        <translation>保留此名称</translation>
    </message>
    <message>
        <source>restore the draft</source>
        <translation>恢复草稿</translation>
    </message>
    <message>
        <source>Nothing was saved: %1 changed here and elsewhere. Choose which version to keep.</source>
        <translation>没有保存任何内容：%1在这里和别处都被更改。请选择保留哪个版本。</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Discard %1 to the waypoints of %2? This cannot be undone.</source>
        <translation>放弃 %2 的路径点的 %1？此操作无法撤销。</translation>
    </message>
    <message>
        <source>There is an unsaved draft of these waypoints from %1: %2.</source>
        <translation>这些路径点有一份 %1 的未保存草稿：%2。</translation>
    </message>
    <message>
        <source>Changes to waypoints are not backed up: save them soon. %1</source>
        <translation>路径点的更改没有备份：请尽快保存。%1</translation>
    </message>
    <message>
        <source>The changes to the waypoints are lost. %1</source>
        <translation>路径点的更改已丢失。%1</translation>
    </message>
    <message>
        <source>Waypoints are not saved</source>
        <translation>路径点未保存</translation>
    </message>
    <message>
        <source>Waypoints of %1: %2 not saved.</source>
        <translation>%1 的路径点：%2未保存。</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointsDock</name>
    <message>
        <source>Waypoints</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add a waypoint in the centre of the view. On the map: press W, then click</source>
        <translation>在视图中央添加路径点。在地图上：按 W，然后单击</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the selected waypoints (Delete)</source>
        <translation>删除选中的路径点 (Delete)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the changes (Ctrl+S)</source>
        <translation>保存更改 (Ctrl+S)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Show the next waypoint with a warning (F8)</source>
        <translation>显示下一个有警告的路径点 (F8)</translation>
    </message>
    <message>
        <source>Filter by name or tag</source>
        <translation>按名称或标签筛选</translation>
    </message>
    <message>
        <source>Filter waypoints</source>
        <translation>筛选路径点</translation>
    </message>
    <message>
        <source>Filter unsaved waypoints</source>
        <translation>筛选未保存的路径点</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>已移动</translation>
    </message>
    <message>
        <source>Renamed</source>
        <translation>已重命名</translation>
    </message>
    <message>
        <source>Retagged</source>
        <translation>已更改标签</translation>
    </message>
    <message>
        <source>Deleted</source>
        <translation>已删除</translation>
    </message>
    <message>
        <source>In conflict</source>
        <translation>有冲突</translation>
    </message>
    <message numerus="yes">
        <source>%1 warnings</source>
        <translation>
            <numerusform>%1 个警告</numerusform>
        </translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>正在保存…</translation>
    </message>
    <message>
        <source>No draft is kept.</source>
        <translation>没有留草稿。</translation>
    </message>
    <message>
        <source>, %1 not saved</source>
        <translation>，%1未保存</translation>
    </message>
    <message>
        <source>Restore what is deleted here before saving.</source>
        <translation>保存之前请恢复在这里删除的内容。</translation>
    </message>
    <message>
        <source>No waypoints yet. Press W and click on the map to add one.</source>
        <translation>还没有路径点。按 W 并在地图上单击即可添加。</translation>
    </message>
    <message>
        <source>There are no waypoints.</source>
        <translation>没有路径点。</translation>
    </message>
    <message>
        <source>No waypoint matches the filter.</source>
        <translation>没有符合筛选的路径点。</translation>
    </message>
    <message>
        <source>&amp;Show on the map</source>
        <translation>在地图上显示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Re&amp;name…</source>
        <translation>重命名(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>恢复(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WaypointsModel</name>
    <message>
        <source>Tags: %1</source>
        <translation>标签：%1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>x m</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y m</source>
        <translation>y (m)</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>yaw °</source>
        <translation>朝向°</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::WindowStatusBar</name>
    <message>
        <source>Show the list of problems</source>
        <translation>显示问题列表</translation>
    </message>
    <message>
        <source>World coordinates under the cursor</source>
        <translation>光标下的世界坐标</translation>
    </message>
    <message>
        <source>Map value under the cursor</source>
        <translation>光标下的地图值</translation>
    </message>
    <message>
        <source>Scale of the map on this screen</source>
        <translation>地图在此屏幕上的比例尺</translation>
    </message>
    <message>
        <source>Rotation of the view, counter-clockwise</source>
        <translation>视图的旋转，逆时针</translation>
    </message>
    <message>
        <source>no robot</source>
        <translation>没有机器人</translation>
    </message>
</context>
<context>
    <name>mapwright::ui::scene::MapScene</name>
    <message>
        <source>A feature of the overlays</source>
        <translation>覆盖物的一个要素</translation>
    </message>
    <message>
        <source>Feature %1</source>
        <translation>要素 %1</translation>
    </message>
    <message>
        <source>It has no slice %1.</source>
        <translation>它没有切片 %1。</translation>
    </message>
    <message>
        <source>Its image could not be loaded.</source>
        <translation>其图像无法加载。</translation>
    </message>
</context>
<context>
    <name>net</name>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>connection refused by %1</source>
        <translation>连接被 %1 拒绝</translation>
    </message>
    <message>
        <source>the host %1 is unknown</source>
        <translation>主机 %1 未知</translation>
    </message>
    <message>
        <source>the robot closed the connection</source>
        <translation>机器人关闭了连接</translation>
    </message>
    <message>
        <source>the robot closed the connection: %1</source>
        <translation>机器人关闭了连接：%1</translation>
    </message>
    <message>
        <source>no secure connection to %1 could be made; the server may not use encryption (http): %2</source>
        <translation>无法与 %1 建立安全连接；服务器可能没有使用加密 (http)：%2</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 没有应答</translation>
    </message>
    <message>
        <source>%1 cannot be reached: %2</source>
        <translation>无法连接到 %1：%2</translation>
    </message>
    <message>
        <source>no answer within %1</source>
        <translation>%1 内没有应答</translation>
    </message>
    <message>
        <source>the robot redirects to another server, %1, which is not followed</source>
        <translation>机器人重定向到另一服务器 %1，未跟随</translation>
    </message>
    <message>
        <source>the robot answered %1: %2</source>
        <translation>机器人应答 %1：%2</translation>
    </message>
    <message>
        <source>the robot refused the connection: %1; the secret may be missing or wrong</source>
        <translation>机器人拒绝了连接：%1；密钥可能缺失或错误</translation>
    </message>
    <message>
        <source>the robot refused the connection: %1</source>
        <translation>机器人拒绝了连接：%1</translation>
    </message>
    <message>
        <source>a message exceeds the %1 bytes allowed</source>
        <translation>有消息超过允许的 %1 字节</translation>
    </message>
    <message>
        <source>the certificate of %1 is not trusted: %3. Its SHA-256 fingerprint: %2</source>
        <translation>%1 的证书不受信任：%3。其 SHA-256 指纹：%2</translation>
    </message>
    <message>
        <source>the certificate of %1 has changed. Trusted (SHA-256): %2. Now: %3</source>
        <translation>%1 的证书已改变。信任的 (SHA-256)：%2。现在的：%3</translation>
    </message>
    <message>
        <source>it is self-signed</source>
        <translation>它是自签名的</translation>
    </message>
    <message>
        <source>it was issued by %1, which is not trusted here</source>
        <translation>它由 %1 颁发，而这里不信任该颁发者</translation>
    </message>
    <message>
        <source>it expired on %1</source>
        <translation>它已于 %1 过期</translation>
    </message>
    <message>
        <source>it is not valid before %1, by the clock of this computer</source>
        <translation>按这台电脑的时钟，它在 %1 之前无效</translation>
    </message>
    <message>
        <source>it was issued for another name (%1)</source>
        <translation>它是为另一名称颁发的（%1）</translation>
    </message>
    <message>
        <source>it was revoked</source>
        <translation>它已被吊销</translation>
    </message>
    <message>
        <source>it is not the trusted one</source>
        <translation>它不是所信任的证书</translation>
    </message>
    <message>
        <source>the folder %1 cannot be created</source>
        <translation>无法创建文件夹 %1</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>%1 cannot be removed: %2</source>
        <translation>无法移除 %1：%2</translation>
    </message>
    <message>
        <source>the connection to %1 was lost</source>
        <translation>与 %1 的连接已断开</translation>
    </message>
    <message>
        <source>the answer was cut off after %1 of %2 bytes</source>
        <translation>应答在 %2 字节中的 %1 字节后被截断</translation>
    </message>
    <message>
        <source>the answer was cut off after %1 bytes</source>
        <translation>应答在 %1 字节后被截断</translation>
    </message>
    <message>
        <source>the robot answered %1</source>
        <translation>机器人应答 %1</translation>
    </message>
    <message>
        <source>this is not the address of a web server</source>
        <translation>这不是 Web 服务器的地址</translation>
    </message>
    <message>
        <source>the robot redirects to another address, which is not followed</source>
        <translation>机器人重定向到另一地址，未跟随</translation>
    </message>
    <message>
        <source>the robot redirects without end</source>
        <translation>机器人无休止地重定向</translation>
    </message>
    <message>
        <source>the certificate of its authority expired on %1</source>
        <translation>其颁发机构的证书已于 %1 过期</translation>
    </message>
    <message>
        <source>it was issued without a name</source>
        <translation>颁发时没有名称</translation>
    </message>
    <message>
        <source>it was issued by an unknown authority</source>
        <translation>它由未知机构颁发</translation>
    </message>
    <message>
        <source>The certificate file %1 cannot be read: %2.</source>
        <translation>无法读取证书文件 %1：%2。</translation>
    </message>
    <message>
        <source>The certificate file %1 contains no certificate in PEM form (-----BEGIN CERTIFICATE-----).</source>
        <translation>证书文件 %1 不含 PEM 格式的证书 (-----BEGIN CERTIFICATE-----)。</translation>
    </message>
    <message>
        <source>%1 does not answer as a WebSocket</source>
        <translation>%1 不以 WebSocket 应答</translation>
    </message>
    <message>
        <source>the robot closed the connection before it was established</source>
        <translation>机器人在连接建立之前关闭了连接</translation>
    </message>
    <message>
        <source>the connection to %1 was lost before it was established</source>
        <translation>与 %1 的连接在建立之前断开</translation>
    </message>
    <message>
        <source>there is no address to connect to</source>
        <translation>没有可连接的地址</translation>
    </message>
</context>
<context>
    <name>overlays</name>
    <message>
        <source>it is not a GeoJSON FeatureCollection</source>
        <translation>它不是 GeoJSON FeatureCollection</translation>
    </message>
    <message>
        <source>it contains no overlays</source>
        <translation>它不含覆盖物</translation>
    </message>
    <message>
        <source>feature %1 has no place</source>
        <translation>要素 %1 没有位置</translation>
    </message>
    <message>
        <source>Its outline encloses no area.</source>
        <translation>其轮廓没有围成面积。</translation>
    </message>
    <message>
        <source>Another feature has the same id, %1.</source>
        <translation>另一要素的编号相同：%1。</translation>
    </message>
    <message>
        <source>Another feature of this kind has the same name, &quot;%1&quot;.</source>
        <translation>同类的另一要素名称相同：“%1”。</translation>
    </message>
    <message>
        <source>This is not a usable coordinate: %1</source>
        <translation>这不是可用的坐标：%1</translation>
    </message>
    <message>
        <source>This is not a usable yaw: %1</source>
        <translation>这不是可用的朝向：%1</translation>
    </message>
    <message>
        <source>A line needs at least two different points.</source>
        <translation>线至少需要两个不同的点。</translation>
    </message>
    <message>
        <source>An outline needs at least three different points.</source>
        <translation>轮廓至少需要三个不同的点。</translation>
    </message>
    <message>
        <source>Its outline crosses itself.</source>
        <translation>其轮廓自交。</translation>
    </message>
    <message>
        <source>This charger names no docking point.</source>
        <translation>此充电桩没有指明对接点。</translation>
    </message>
    <message>
        <source>The docking point of this charger, %1, does not exist, or is none.</source>
        <translation>此充电桩的对接点 %1 不存在，或不是对接点。</translation>
    </message>
    <message>
        <source>This door has no MAC address.</source>
        <translation>此门没有 MAC 地址。</translation>
    </message>
    <message>
        <source>It lies outside the map.</source>
        <translation>它在地图之外。</translation>
    </message>
    <message>
        <source>It lies in a wall.</source>
        <translation>它在墙内。</translation>
    </message>
    <message>
        <source>The robot cannot get here from its charger.</source>
        <translation>机器人无法从充电桩到达这里。</translation>
    </message>
    <message>
        <source>number %1 in the list is no feature</source>
        <translation>列表中第 %1 项不是要素</translation>
    </message>
    <message>
        <source>the geometry of feature %1 is of an unknown type, &quot;%2&quot;</source>
        <translation>要素 %1 的几何类型未知：“%2”</translation>
    </message>
    <message>
        <source>feature %1 has a coordinate that cannot be used: %2</source>
        <translation>要素 %1 有不可用的坐标：%2</translation>
    </message>
    <message>
        <source>feature %1 has too few points</source>
        <translation>要素 %1 的点太少</translation>
    </message>
    <message>
        <source>it contains more than %1 features</source>
        <translation>它含有超过 %1 个要素</translation>
    </message>
    <message>
        <source>it has more than one list of features</source>
        <translation>它有不止一个要素列表</translation>
    </message>
    <message>
        <source>Its geometry has no points.</source>
        <translation>其几何没有点。</translation>
    </message>
    <message>
        <source>Its geometry is of an unknown type: %1</source>
        <translation>其几何类型未知：%1</translation>
    </message>
    <message>
        <source>This is no GeoJSON Feature, so it is not shown.</source>
        <translation>这不是 GeoJSON Feature，因此未显示。</translation>
    </message>
    <message>
        <source>Its &quot;%1&quot; is written twice. The last one counts.</source>
        <translation>其“%1”写了两次，以最后一个为准。</translation>
    </message>
</context>
<context>
    <name>pbstream</name>
    <message>
        <source>The file is damaged, so nothing of it can be left out safely</source>
        <translation>文件已损坏，因此无法安全地去掉其中任何内容</translation>
    </message>
    <message>
        <source>There is no trajectory %1 in it.</source>
        <translation>其中没有轨迹 %1。</translation>
    </message>
    <message>
        <source>Without its only trajectory nothing would be left.</source>
        <translation>去掉唯一的轨迹就什么也不剩了。</translation>
    </message>
    <message>
        <source>There is no submap %1 in it.</source>
        <translation>其中没有子图 %1。</translation>
    </message>
    <message>
        <source>%1 and %2 are no loop closure: the scan was inserted into that submap.</source>
        <translation>%1 与 %2 不是回环：该激光扫描是插入到该子图中的。</translation>
    </message>
    <message>
        <source>There is no constraint between submap %1 and node %2 in it.</source>
        <translation>其中没有子图 %1 与节点 %2 之间的约束。</translation>
    </message>
    <message>
        <source>It has options for %1 trajectories and holds %2. So the options of a single one cannot be found.</source>
        <translation>它有 %1 条轨迹的选项，却含有 %2 条，因此无法确定单条轨迹的选项。</translation>
    </message>
    <message>
        <source>The constraint between submap %1 and node %2 would refer to what is not there.</source>
        <translation>子图 %1 与节点 %2 之间的约束会指向不存在的内容。</translation>
    </message>
    <message>
        <source>%1 exists already. A state file is never written over: choose another name.</source>
        <translation>%1 已存在。状态文件从不覆盖：请另选名称。</translation>
    </message>
    <message>
        <source>The new file is not what it should be, and was removed.</source>
        <translation>新文件与应有的内容不符，已移除。</translation>
    </message>
    <message>
        <source>there is not enough memory to rewrite it</source>
        <translation>内存不足，无法重新写出</translation>
    </message>
    <message>
        <source>it cannot be read any more</source>
        <translation>它已无法读取</translation>
    </message>
    <message>
        <source>%1 is not a Cartographer state file.</source>
        <translation>%1 不是 Cartographer 状态文件。</translation>
    </message>
    <message>
        <source>It is a Cartographer state file of version %1. Versions 1 and 2 can be read. cartographer_migrate_serialization_format converts older ones.</source>
        <translation>这是版本 %1 的 Cartographer 状态文件。可读取版本 1 和 2。更旧的可用 cartographer_migrate_serialization_format 转换。</translation>
    </message>
    <message>
        <source>it is not the message that it should be</source>
        <translation>它不是应有的消息</translation>
    </message>
    <message>
        <source>field %1 has another type than in Cartographer&apos;s own files</source>
        <translation>字段 %1 的类型与 Cartographer 自己的文件不同</translation>
    </message>
    <message>
        <source>The file is cut off in record %1 at byte %2: what follows is missing.</source>
        <translation>文件在第 %1 条记录、第 %2 字节处被截断：其后内容缺失。</translation>
    </message>
    <message>
        <source>it was cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>its pose graph has more than %1 parts of one kind</source>
        <translation>其位姿图中同一类内容超过 %1 个</translation>
    </message>
    <message>
        <source>trajectories, nodes or submaps that are listed twice: %1; the first of each counts</source>
        <translation>重复列出的轨迹、节点或子图：%1；各以第一个为准</translation>
    </message>
    <message>
        <source>constraints of a kind that is not known: %1; they count as INTER</source>
        <translation>类型未知的约束：%1；按 INTER 计</translation>
    </message>
    <message>
        <source>Record %1 at byte %2</source>
        <translation>第 %1 条记录，第 %2 字节处</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 无法读取</translation>
    </message>
    <message>
        <source>it unpacks to more than 2 GB</source>
        <translation>它解包后超过 2 GB</translation>
    </message>
    <message>
        <source>its gzip stream is damaged</source>
        <translation>其 gzip 流已损坏</translation>
    </message>
    <message>
        <source>its gzip stream ends too early</source>
        <translation>其 gzip 流过早结束</translation>
    </message>
    <message>
        <source>It holds no records.</source>
        <translation>它不含记录。</translation>
    </message>
    <message>
        <source>from there on %1 bytes are zero</source>
        <translation>从那里起 %1 字节为零，其中没有内容</translation>
    </message>
    <message>
        <source>it is not the header of a state file</source>
        <translation>它不是状态文件的文件头</translation>
    </message>
    <message>
        <source>it is of a kind that is not known</source>
        <translation>它的类型未知</translation>
    </message>
    <message>
        <source>there is another pose graph before it: that one counts</source>
        <translation>它之前有另一个位姿图：以那个为准</translation>
    </message>
    <message>
        <source>there are too many submaps before it</source>
        <translation>它之前的子图太多</translation>
    </message>
    <message>
        <source>submap %1 is in the file before it: that one counts</source>
        <translation>子图 %1 在文件中已出现过：以先前的为准</translation>
    </message>
    <message>
        <source>It holds no pose graph, so nothing in it has a place.</source>
        <translation>它不含位姿图，因此其中的内容都没有位置。</translation>
    </message>
    <message>
        <source>There are more of these: %1.</source>
        <translation>此类内容还有更多：%1。</translation>
    </message>
    <message>
        <source>Submaps without a place in the pose graph: %1 (%2).</source>
        <translation>位姿图中没有位置的子图：%1（%2）。</translation>
    </message>
    <message>
        <source>Submaps that are missing although the pose graph gives them a place: %1 (%2).</source>
        <translation>位姿图给出了位置但缺失的子图：%1（%2）。</translation>
    </message>
    <message>
        <source>its pose is not one: a number is not finite, or it has no direction</source>
        <translation>其位姿无效：有数字不是有限值，或没有方向</translation>
    </message>
    <message>
        <source>its grid claims to have %1 cells</source>
        <translation>其栅格地图声称有 %1 个栅格</translation>
    </message>
    <message>
        <source>its grid of %1 cells holds %2 values</source>
        <translation>其 %1 个栅格的栅格地图含有 %2 个值</translation>
    </message>
    <message>
        <source>the place or the cell size of its grid is not a number of metres</source>
        <translation>其栅格地图的位置或栅格大小不是以米为单位的数字</translation>
    </message>
    <message>
        <source>the box of its known cells is not within its grid</source>
        <translation>其已知栅格的外框不在栅格地图之内</translation>
    </message>
    <message>
        <source>the bounds of its probabilities are not between 0 and 1</source>
        <translation>其概率的界限不在 0 与 1 之间</translation>
    </message>
    <message>
        <source>the truncation distance or the weight of its distances is not positive</source>
        <translation>其距离的截断距离或权重不是正数</translation>
    </message>
    <message>
        <source>it holds no grid</source>
        <translation>它不含栅格地图</translation>
    </message>
    <message>
        <source>its cells do not all have three indices and a value</source>
        <translation>其栅格并非都有三个索引和一个值</translation>
    </message>
    <message>
        <source>the cell size of its grid is not a positive number of metres</source>
        <translation>其栅格地图的栅格大小不是以米为单位的正数</translation>
    </message>
    <message>
        <source>its cells lie too far apart, or from the origin of the map</source>
        <translation>其栅格彼此相距太远，或离地图原点太远</translation>
    </message>
    <message>
        <source>its cells lie too far apart: seen from above it would have %1 cells</source>
        <translation>其栅格相距太远：俯视会有 %1 个栅格</translation>
    </message>
    <message>
        <source>it has more values than it may have</source>
        <translation>它的值比允许的多</translation>
    </message>
    <message>
        <source>one of its parts is too large</source>
        <translation>它的某个部分太大</translation>
    </message>
    <message>
        <source>The file does not contain this submap.</source>
        <translation>文件不含此子图。</translation>
    </message>
    <message>
        <source>%1 losses, the first of them</source>
        <translation>%1 处损失，其中前几处</translation>
    </message>
    <message>
        <source>%1 losses</source>
        <translation>%1 处损失</translation>
    </message>
</context>
<context>
    <name>recorded</name>
    <message>
        <source>The recording %1 cannot be opened</source>
        <translation>无法打开录制文件 %1</translation>
    </message>
    <message>
        <source>Its end is missing: recording was interrupted after %1, or is still going on.</source>
        <translation>缺少结尾：录制在 %1 后被中断，或仍在进行。</translation>
    </message>
    <message>
        <source>Its end is missing and it has no messages yet: recording was interrupted, or is still going on.</source>
        <translation>缺少结尾，且还没有消息：录制被中断，或仍在进行。</translation>
    </message>
    <message>
        <source>It is cut off at byte %1. Everything before that is played.</source>
        <translation>它在第 %1 字节处被截断。此前的内容全部播放。</translation>
    </message>
    <message numerus="yes">
        <source>%1 bytes of it cannot be read (from byte %2 on) and are skipped.</source>
        <translation>
            <numerusform>其中 %1 字节无法读取（从第 %2 字节起），已跳过。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it cannot be unpacked (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>其中 %1 个数据块无法解包（第一个在第 %2 字节处），已跳过。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it are corrupted (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>其中 %1 个数据块已损坏（第一个在第 %2 字节处），已跳过。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it would need too much memory (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>其中 %1 个数据块会占用太多内存（第一个在第 %2 字节处），已跳过。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it use an unknown compression: %3 (the first at byte %2). They are skipped.</source>
        <translation>
            <numerusform>其中 %1 个数据块使用未知的压缩：%3（第一个在第 %2 字节处），已跳过。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 chunks of it state a wrong time range (the first at byte %2).</source>
        <translation>
            <numerusform>其中 %1 个数据块所标的时间范围有误（第一个在第 %2 字节处）。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 message definitions in it are too large (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>其中 %1 个消息定义太大（第一个在第 %2 字节处），已跳过。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 message definitions in it cannot be read (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>其中 %1 个消息定义无法读取（第一个在第 %2 字节处），已跳过。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 messages belong to topics that it does not describe (the first at byte %2) and are skipped.</source>
        <translation>
            <numerusform>%1 条消息所属的话题在其中没有描述（第一条在第 %2 字节处），已跳过。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 topics are described twice and differently (the first at byte %2). The first description is used.</source>
        <translation>
            <numerusform>%1 个话题有两份不同的描述（第一个在第 %2 字节处），采用第一份描述。</numerusform>
        </translation>
    </message>
    <message>
        <source>The file %1 in the recording is damaged.</source>
        <translation>录制文件中的文件 %1 已损坏。</translation>
    </message>
    <message numerus="yes">
        <source>It is damaged: after %1 messages no more of it can be read.</source>
        <translation>
            <numerusform>它已损坏：%1 条消息之后无法再读取。</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording does not define the message type %1.</source>
        <translation>录制文件没有定义消息类型 %1。</translation>
    </message>
    <message>
        <source>Messages with encoding &quot;%1&quot; and definitions in &quot;%2&quot; are not supported.</source>
        <translation>不支持编码为“%1”、定义为“%2”的消息。</translation>
    </message>
    <message>
        <source>The recording does not contain this submap.</source>
        <translation>录制文件不含此子图。</translation>
    </message>
    <message>
        <source>The recording does not contain the picture that this message names.</source>
        <translation>录制文件不含此消息所指的图像。</translation>
    </message>
    <message>
        <source>Messages with encoding &quot;%1&quot; are not supported, only their bytes are shown.</source>
        <translation>不支持编码为“%1”的消息，只显示其字节。</translation>
    </message>
    <message>
        <source>It contains no topic in the namespace %1.</source>
        <translation>它不含命名空间 %1 中的话题。</translation>
    </message>
    <message>
        <source>It contains no robot %1, only %2.</source>
        <translation>它不含机器人 %1，只有 %2。</translation>
    </message>
    <message>
        <source>It contains several robots: %1. Shown as the robot is %2. To see another one, add ?ns=/NAMESPACE to the address of the file.</source>
        <translation>它含有多台机器人：%1。当前显示的机器人是 %2。要看另一台，请在文件地址后加 ?ns=/NAMESPACE。</translation>
    </message>
    <message>
        <source>recordings on this computer are read-only here</source>
        <translation>这台电脑上的录制文件在这里只读</translation>
    </message>
    <message>
        <source>It has no index, so the whole file was scanned. Opening it takes longer.</source>
        <translation>它没有索引，因此扫描了整个文件，打开所需时间更长。</translation>
    </message>
    <message>
        <source>Its index is damaged, so the whole file was scanned.</source>
        <translation>其索引已损坏，因此扫描了整个文件。</translation>
    </message>
    <message>
        <source>The disk cannot read it at byte %1.</source>
        <translation>磁盘无法读取其第 %1 字节处。</translation>
    </message>
    <message>
        <source>Its file %1 is missing or cannot be read. The others are played.</source>
        <translation>其文件 %1 缺失或无法读取。播放其余文件。</translation>
    </message>
    <message>
        <source>It is compressed as a whole (zstd), so it was unpacked to a temporary file.</source>
        <translation>它是整体压缩的 (zstd)，因此已解包到临时文件。</translation>
    </message>
    <message>
        <source>It is neither an MCAP file nor a bag of ROS 1 or ROS 2.</source>
        <translation>它既不是 MCAP 文件，也不是 ROS 1 或 ROS 2 的数据包。</translation>
    </message>
    <message>
        <source>It is compressed (zstd), and damaged or too large to be unpacked.</source>
        <translation>它是压缩的 (zstd)，并且已损坏或太大而无法解包。</translation>
    </message>
    <message>
        <source>It is a pointer of Git LFS, not the recording itself (git lfs pull fetches it).</source>
        <translation>它是 Git LFS 的指针，不是录制文件本身（可用 git lfs pull 获取）。</translation>
    </message>
    <message>
        <source>This version of the format is not supported. MCAP 0 and ROS bags of version 2.0 are.</source>
        <translation>不支持此格式版本。支持 MCAP 0 和 2.0 版的 ROS 数据包。</translation>
    </message>
    <message>
        <source>Its messages are encrypted. Decrypt it with rosbag first.</source>
        <translation>其消息已加密。请先用 rosbag 解密。</translation>
    </message>
    <message>
        <source>The definition of %1 is longer than that of any real message.</source>
        <translation>%1 的定义比任何真实消息的定义都长。</translation>
    </message>
    <message>
        <source>The definition of %1 cannot be read (line %2: &quot;%3&quot;).</source>
        <translation>%1 的定义无法读取（第 %2 行：“%3”）。</translation>
    </message>
    <message>
        <source>The definition of %1 does not define %2.</source>
        <translation>%1 的定义没有定义 %2。</translation>
    </message>
    <message>
        <source>The definition of %1 is recursive: %2 contains itself.</source>
        <translation>%1 的定义是递归的：%2 包含自身。</translation>
    </message>
    <message>
        <source>The encoding of the message is not the one stated in the recording (%1).</source>
        <translation>消息的编码与录制文件所标的（%1）不同。</translation>
    </message>
    <message>
        <source>The message ends inside its field &quot;%1&quot;.</source>
        <translation>消息在其字段“%1”中间结束。</translation>
    </message>
    <message>
        <source>The message is too large to be read, at its field &quot;%1&quot;.</source>
        <translation>消息太大，无法读取，位于其字段“%1”。</translation>
    </message>
    <message>
        <source>The message has a field of type wstring (&quot;%1&quot;), which is not supported.</source>
        <translation>消息有 wstring 类型的字段（“%1”），不支持该类型。</translation>
    </message>
    <message>
        <source>The connection to the robot was lost from %1 to the end.</source>
        <translation>从 %1 到结尾，与机器人的连接已断开。</translation>
    </message>
    <message>
        <source>The connection to the robot was lost from %1 to %2.</source>
        <translation>从 %1 到 %2，与机器人的连接断开。</translation>
    </message>
    <message numerus="yes">
        <source>%1 messages have no usable time and are left out.</source>
        <translation>
            <numerusform>%1 条消息没有可用的时间，已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 messages that it counts are not in it.</source>
        <translation>
            <numerusform>其自身计数中有 %1 条消息实际不在其中。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A message has %1 bytes more than its definition describes: the definition may be another one. They are not shown.</source>
        <translation>
            <numerusform>有一条消息比其定义多 %1 字节：定义可能不是它的。这些字节未显示。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 files of it are not played: it has too many.</source>
        <translation>
            <numerusform>其中 %1 个文件未播放：文件太多。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Its metadata.yaml is missing or damaged, as after an interrupted recording. The %1 files in its folder are played.</source>
        <translation>
            <numerusform>其 metadata.yaml 缺失或已损坏（例如录制被中断）。播放文件夹中的 %1 个文件。</numerusform>
        </translation>
    </message>
    <message>
        <source>It is an SQLite database, but no bag of ROS 2, or one that is damaged or cut off.</source>
        <translation>这是 SQLite 数据库，但不是 ROS 2 包，或者已损坏或不完整。</translation>
    </message>
</context>
<context>
    <name>render</name>
    <message>
        <source>The resolution must be greater than 0.</source>
        <translation>分辨率必须大于 0。</translation>
    </message>
    <message>
        <source>The map is too large for one picture at this resolution. Choose a coarser one.</source>
        <translation>按此分辨率，地图太大，放不进一幅图像。请选择更粗的分辨率。</translation>
    </message>
    <message>
        <source>There are no submaps to export yet.</source>
        <translation>还没有可导出的子图。</translation>
    </message>
</context>
<context>
    <name>replay</name>
    <message>
        <source>Not all of it can be read</source>
        <translation>无法全部读取</translation>
    </message>
    <message>
        <source>%1 to %2 is missing</source>
        <translation>缺少 %1 到 %2</translation>
    </message>
    <message>
        <source>and more parts: %1</source>
        <translation>及更多部分：%1</translation>
    </message>
    <message>
        <source>the robot answered %1</source>
        <translation>机器人应答 %1</translation>
    </message>
</context>
<context>
    <name>robot</name>
    <message>
        <source>The robot does not support that.</source>
        <translation>该机器人不支持此操作。</translation>
    </message>
    <message>
        <source>It answered: %1</source>
        <translation>它应答：%1</translation>
    </message>
    <message>
        <source>another waypoint of this map is called &quot;%1&quot;, too; rename one of the two</source>
        <translation>此地图的另一路径点也名为“%1”；请重命名其中一个</translation>
    </message>
    <message>
        <source>Its projections are unknown: it does not list its topics and services (its node rosapi is not running), and nothing has arrived on the usual topics (projected_map_0 and so on).</source>
        <translation>其投影未知：它不列出话题和服务（其节点 rosapi 未运行），在常用话题（projected_map_0 等）上也没有收到内容。</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message numerus="yes">
        <source>%1 features of its overlays cannot be read.</source>
        <translation>
            <numerusform>其覆盖物中有 %1 个要素无法读取。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ros</name>
    <message>
        <source>Its field %1 is missing or cannot be read.</source>
        <translation>其字段 %1 缺失或无法读取。</translation>
    </message>
    <message>
        <source>Its field %1 is %2, which is not valid.</source>
        <translation>其字段 %1 为 %2，无效。</translation>
    </message>
    <message>
        <source>Its field %1 has %2 values, but according to its other fields it should have %3.</source>
        <translation>其字段 %1 有 %2 个值，但按其他字段应有 %3 个。</translation>
    </message>
    <message>
        <source>Its rows are %1 bytes long (row_step), but its points take %2 of them (width and point_step). The remaining bytes are ignored.</source>
        <translation>其每行长 %1 字节 (row_step)，但其中的点占 %2 字节（width 和 point_step）。其余字节被忽略。</translation>
    </message>
    <message>
        <source>It has no cells: it is %1 x %2.</source>
        <translation>它没有栅格：大小为 %1 x %2。</translation>
    </message>
    <message>
        <source>Its orientation is not a rotation (a zero quaternion). It is shown with yaw 0.</source>
        <translation>其方向不是旋转（零四元数）。按朝向 0 显示。</translation>
    </message>
    <message>
        <source>An update of %1 x %2 cells at %3, %4 does not fit into its %5 x %6 cells. It was left out.</source>
        <translation>位于 %3, %4 的一个 %1 x %2 栅格的更新，放不进其 %5 x %6 个栅格，已略去。</translation>
    </message>
    <message>
        <source>It has %1 points, too many to draw. One in %2 is shown.</source>
        <translation>它有 %1 个点，太多而无法绘制。每 %2 个显示一个。</translation>
    </message>
    <message>
        <source>An update of it is in the frame %1, but the map is in the frame %2. The update was left out.</source>
        <translation>它的一个更新在坐标系 %1 中，而地图在坐标系 %2 中。该更新已略去。</translation>
    </message>
    <message>
        <source>The robot has not sent a transform for the frame %1 yet, so its position is unknown.</source>
        <translation>机器人尚未发送坐标系 %1 的变换，因此其位置未知。</translation>
    </message>
    <message>
        <source>No transforms connect the frame %1 to the frame %2, so its position is unknown.</source>
        <translation>没有变换连接坐标系 %1 与坐标系 %2，因此其位置未知。</translation>
    </message>
    <message>
        <source>Neither a map nor a transform gives the position of the frame %1. Everything is shown in that frame, as if the robot never moved.</source>
        <translation>地图和变换都没有给出坐标系 %1 的位置。全部内容按该坐标系显示，如同机器人从未移动。</translation>
    </message>
    <message numerus="yes">
        <source>%1 markers cannot be placed</source>
        <translation>
            <numerusform>%1 个标记无法放置</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 markers are meshes (%2), which are not read: spots are drawn in their places.</source>
        <translation>
            <numerusform>%1 个标记是网格模型（%2），不读取：在其位置画点。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 markers are of an unknown kind and are not drawn.</source>
        <translation>
            <numerusform>%1 个标记类型未知，不绘制。</numerusform>
        </translation>
    </message>
    <message>
        <source>There are several robots: %1. Add ?ns=/NAMESPACE to the address to see one of them alone.</source>
        <translation>有多台机器人：%1。在地址后加 ?ns=/NAMESPACE 可只看其中一台。</translation>
    </message>
    <message>
        <source>It is older than the transforms from %1 to %2 that are kept, so its position is unknown. The clocks of the robot may differ.</source>
        <translation>它早于所保留的从 %1 到 %2 的变换，因此其位置未知。机器人的时钟可能不一致。</translation>
    </message>
    <message>
        <source>It is newer than the last transform from %1 to %2, so its position is unknown. The node that sends this transform may be late or have stopped.</source>
        <translation>它晚于从 %1 到 %2 的最后一个变换，因此其位置未知。发送该变换的节点可能延迟或已停止。</translation>
    </message>
    <message>
        <source>A transform from %1 to %2 would close a loop of frames and was left out: two nodes of the robot contradict each other.</source>
        <translation>从 %1 到 %2 的一个变换会使坐标系成环，已略去：机器人的两个节点相互矛盾。</translation>
    </message>
    <message>
        <source>Waiting: nothing arrives on this topic now</source>
        <translation>等待中：此话题上现在没有内容到达</translation>
    </message>
    <message>
        <source>the robot does not have this topic now</source>
        <translation>机器人现在没有此话题</translation>
    </message>
    <message>
        <source>the topic exists, but no node of the robot publishes it</source>
        <translation>话题存在，但机器人没有节点发布它</translation>
    </message>
    <message>
        <source>the robot does not list its topics (its node rosapi is not running), so it may not have this one</source>
        <translation>机器人不列出话题（其节点 rosapi 未运行），因此可能没有此话题</translation>
    </message>
    <message>
        <source>the topic exists; it may have nothing to send now, or the rosbridge server may lack its message type</source>
        <translation>话题存在；可能现在没有可发送的内容，或 rosbridge 服务器缺少其消息类型</translation>
    </message>
    <message>
        <source>Nothing has arrived on this topic. The map was requested from the service %1 and is shown as it was then.</source>
        <translation>此话题上没有内容到达。地图已通过服务 %1 请求，按当时的样子显示。</translation>
    </message>
    <message>
        <source>The service %1 did not provide the map either: %2. It will be called again.</source>
        <translation>服务 %1 也没有提供地图：%2。将再次调用。</translation>
    </message>
    <message>
        <source>Nothing was sent to the robot: the position and size of a region must be numbers, and the size greater than 0 m.</source>
        <translation>没有向机器人下发任何内容：分块的位置和大小必须是数字，且大小大于 0 m。</translation>
    </message>
    <message>
        <source>Nothing was sent to the robot: a file name must have 1 to 4,096 bytes, without line breaks or other control characters.</source>
        <translation>没有向机器人下发任何内容：文件名必须为 1 到 4,096 字节，不含换行或其他控制字符。</translation>
    </message>
    <message>
        <source>Nothing was sent to the robot: the position and heights of a projection must be numbers, its size greater than 0 m, and its lower height below the upper one.</source>
        <translation>没有向机器人下发任何内容：投影的位置和高度必须是数字，大小须大于 0 m，下限高度须低于上限高度。</translation>
    </message>
    <message>
        <source>The robot sends this map by region, and the whole map has not been loaded yet.</source>
        <translation>机器人按分块发送此地图，整张地图尚未加载。</translation>
    </message>
    <message>
        <source>the robot did not answer in time</source>
        <translation>机器人没有及时应答</translation>
    </message>
    <message>
        <source>the connection was lost</source>
        <translation>连接已断开</translation>
    </message>
    <message>
        <source>the answer contains no result</source>
        <translation>应答中没有结果</translation>
    </message>
    <message>
        <source>it has no such map</source>
        <translation>它没有这张地图</translation>
    </message>
    <message>
        <source>it failed without saying why</source>
        <translation>失败，未说明原因</translation>
    </message>
    <message>
        <source>it considers the request invalid</source>
        <translation>它认为请求无效</translation>
    </message>
    <message>
        <source>another map is already called &quot;%1&quot;; choose another name</source>
        <translation>另一张地图已名为“%1”；请另选名称</translation>
    </message>
    <message>
        <source>the answer %1 is unknown to this program</source>
        <translation>本程序不认识应答 %1</translation>
    </message>
    <message>
        <source>not confirmed: the robot reported success, but did not show the change within %1 s. Check again</source>
        <translation>未确认：机器人报告成功，但 %1 s 内没有显示该更改。请再次检查</translation>
    </message>
    <message>
        <source>The robot accepted the change of &quot;%1&quot;, but not its tags. To remove its last tag, delete the waypoint and create it again.</source>
        <translation>机器人接受了“%1”的更改，但没有接受其标签。要移除最后一个标签，请删除该路径点并重新创建。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed on the robot in the meantime</source>
        <translation>“%1”在此期间于机器人上被更改</translation>
    </message>
    <message>
        <source>The robot only sends its current map. Load this one on the robot to see it.</source>
        <translation>机器人只发送其当前地图。要看这张，请在机器人上加载它。</translation>
    </message>
    <message>
        <source>The robot only sends its current map, so only that picture can be saved and compared. Nothing was sent. Load this map on the robot first.</source>
        <translation>机器人只发送其当前地图，因此只能保存和比较该图像。没有下发任何内容。请先在机器人上加载此地图。</translation>
    </message>
    <message>
        <source>Some of its cells are neither free, occupied nor unknown but in between (%1 of 100), and the map manager has no gray level for these. Nothing was sent. Export the map to edit it as files.</source>
        <translation>其中有些栅格既不是空闲、占据，也不是未知，而是介于其间（100 级中的 %1），地图管理器没有相应的灰度级。没有下发任何内容。请导出地图，作为文件编辑。</translation>
    </message>
    <message numerus="yes">
        <source>The robot accepted the picture, but shows %1 cells differently. Compare the two.</source>
        <translation>
            <numerusform>机器人接受了图像，但有 %1 个栅格显示得不同。请比较两者。</numerusform>
        </translation>
    </message>
    <message>
        <source>The message does not have the expected fields. It was left out.</source>
        <translation>消息没有应有的字段，已略去。</translation>
    </message>
    <message>
        <source>Waypoint &quot;%1&quot; has no heading (a zero quaternion). It is shown with yaw 0, and kept unchanged until you turn it.</source>
        <translation>路径点“%1”没有朝向（零四元数）。按朝向 0 显示，在您旋转它之前保持不变。</translation>
    </message>
    <message>
        <source>This list may be out of date: it comes from a topic, and the map manager did not confirm it (get_waypoint)</source>
        <translation>此列表可能已过时：它来自话题，地图管理器没有确认它 (get_waypoint)</translation>
    </message>
    <message>
        <source>Waypoint &quot;%1&quot; is in the frame %2, and the frame of the map is not known yet. It is assumed to be on the map.</source>
        <translation>路径点“%1”在坐标系 %2 中，而地图的坐标系尚未知。假定它在地图上。</translation>
    </message>
    <message>
        <source>there is a rosbridge server at %1, but its robot has no KABAM map manager (/map_manager). Start it, or connect to ros+ws:// to use everything else.</source>
        <translation>%1 有 rosbridge 服务器，但其机器人没有 KABAM 地图管理器 (/map_manager)。请启动它，或连接 ros+ws:// 以使用其他全部功能。</translation>
    </message>
    <message>
        <source>the waypoint no longer exists</source>
        <translation>路径点已不存在</translation>
    </message>
    <message>
        <source>it already uses this map</source>
        <translation>它已在使用此地图</translation>
    </message>
    <message>
        <source>it considers the request invalid; it may need to know at which waypoint it stands</source>
        <translation>它认为请求无效；可能需要知道它停在哪个路径点</translation>
    </message>
    <message>
        <source>it considers the request invalid; there may be nothing to save, or the name may not be allowed</source>
        <translation>它认为请求无效；可能没有可保存的内容，或不允许此名称</translation>
    </message>
    <message>
        <source>Waypoint &quot;%1&quot; is in the frame %2 instead of %3. It was left out.</source>
        <translation>路径点“%1”在坐标系 %2 中，而不是 %3，已略去。</translation>
    </message>
    <message>
        <source>the picture of &quot;%1&quot; was changed on the robot in the meantime</source>
        <translation>“%1”的图像在此期间于机器人上被更改</translation>
    </message>
    <message>
        <source>the robot&apos;s map manager did not list its maps in time; it may be busy, or the rosbridge server may lack its message types (kabam_msgs)</source>
        <translation>机器人的地图管理器没有及时列出地图；可能正忙，或 rosbridge 服务器缺少其消息类型 (kabam_msgs)</translation>
    </message>
    <message>
        <source>The rosbridge server does not accept a second connection: %1. Maps and clouds share the connection with poses, so poses may be late while a map is sent.</source>
        <translation>rosbridge 服务器不接受第二个连接：%1。地图和点云与位姿共用连接，因此发送地图时位姿可能延迟。</translation>
    </message>
    <message>
        <source>there is a server at %1, but not a rosbridge server: %2. Check the address and the port.</source>
        <translation>%1 有服务器，但不是 rosbridge 服务器：%2。请检查地址和端口。</translation>
    </message>
    <message>
        <source>there is no connection to the robot</source>
        <translation>没有与机器人的连接</translation>
    </message>
    <message>
        <source>The robot sends no map in the plane, only projections of its 3D map: choose one of them (projected_map_0 and so on).</source>
        <translation>机器人不发送平面地图，只发送其 3D 地图的投影：请选择其中一个（projected_map_0 等）。</translation>
    </message>
    <message>
        <source>a WebSocket opens there, but nothing answers the requests of rosbridge</source>
        <translation>那里可以打开 WebSocket，但没有应答 rosbridge 的请求</translation>
    </message>
    <message numerus="yes">
        <source>%1 markers are left out or cut: they cannot be read, or there are too many.</source>
        <translation>
            <numerusform>%1 个标记被略去或截短：无法读取，或者数量太多。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more waypoints were left out.</source>
        <translation>
            <numerusform>还有 %1 个路径点已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 more waypoints have no direction, or a frame that is unknown.</source>
        <translation>
            <numerusform>还有 %1 个路径点没有方向，或其坐标系未知。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>scene</name>
    <message>
        <source>Coverage</source>
        <translation>覆盖次数</translation>
    </message>
    <message>
        <source>covers the map</source>
        <translation>会遮住地图</translation>
    </message>
    <message>
        <source>Disagreement</source>
        <translation>不一致</translation>
    </message>
    <message>
        <source>takes a while</source>
        <translation>需要一些时间</translation>
    </message>
    <message>
        <source>Pallets, racks, markers</source>
        <translation>托盘、货架、标记</translation>
    </message>
    <message>
        <source>Loop closures</source>
        <translation>回环</translation>
    </message>
    <message>
        <source>Point cloud of the map</source>
        <translation>地图的点云</translation>
    </message>
    <message>
        <source>may be large</source>
        <translation>可能很大</translation>
    </message>
    <message>
        <source>Point size</source>
        <translation>点大小</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>By height</source>
        <translation>按高度</translation>
    </message>
    <message>
        <source>By intensity</source>
        <translation>按强度</translation>
    </message>
    <message>
        <source>Own colour</source>
        <translation>自带颜色</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>单色</translation>
    </message>
    <message>
        <source>Constraints</source>
        <translation>约束</translation>
    </message>
    <message>
        <source>Auto doors</source>
        <translation>自动门</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>路标</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>环境</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>标注</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>线宽</translation>
    </message>
    <message>
        <source>There is no live data here, so this layer stays empty.</source>
        <translation>这里没有实时数据，因此此图层为空。</translation>
    </message>
    <message>
        <source>This robot does not provide this.</source>
        <translation>该机器人不提供此内容。</translation>
    </message>
    <message>
        <source>There is nothing of the kind in this file.</source>
        <translation>此文件中没有此类内容。</translation>
    </message>
    <message>
        <source>Lidar points</source>
        <translation>激光雷达点</translation>
    </message>
    <message>
        <source>Local path</source>
        <translation>局部路径</translation>
    </message>
    <message>
        <source>Nearby robots</source>
        <translation>附近的机器人</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Submap ids</source>
        <translation>子图编号</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>覆盖物</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>fetch failed</source>
        <translation>获取失败</translation>
    </message>
    <message>
        <source>corrupt</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>no slice</source>
        <translation>没有切片</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>What is missing</source>
        <translation>缺少的内容</translation>
    </message>
    <message>
        <source>Not fetched yet</source>
        <translation>尚未获取</translation>
    </message>
    <message>
        <source>Being fetched</source>
        <translation>正在获取</translation>
    </message>
    <message>
        <source>Fetch failed</source>
        <translation>获取失败</translation>
    </message>
    <message>
        <source>Old: could not be fetched again</source>
        <translation>旧内容：未能重新获取</translation>
    </message>
    <message>
        <source>Fetched; the map is empty here</source>
        <translation>已获取；地图在这里为空</translation>
    </message>
    <message>
        <source>Edge of the map</source>
        <translation>地图边缘</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>being fetched…</source>
        <translation>正在获取…</translation>
    </message>
    <message>
        <source>Map by regions</source>
        <translation>分块地图</translation>
    </message>
    <message>
        <source>This robot only sends its map as a whole.</source>
        <translation>该机器人只发送整张地图。</translation>
    </message>
    <message>
        <source>Incremental</source>
        <translation>增量</translation>
    </message>
    <message>
        <source>Match map</source>
        <translation>匹配地图</translation>
    </message>
    <message>
        <source>Symmetry map</source>
        <translation>对称地图</translation>
    </message>
    <message>
        <source>Costmap, global or coarse</source>
        <translation>代价地图，全局或粗略</translation>
    </message>
    <message>
        <source>Costmap, local or fine</source>
        <translation>代价地图，局部或精细</translation>
    </message>
    <message>
        <source>Trail</source>
        <translation>尾迹</translation>
    </message>
    <message>
        <source>Wide footprint</source>
        <translation>加宽的机器人外形</translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation>机器人外形</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source> km</source>
        <translation> km</translation>
    </message>
    <message>
        <source> km²</source>
        <translation> km²</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>比例尺</translation>
    </message>
    <message>
        <source>Submaps</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Track of the bag</source>
        <translation>数据包的行驶轨迹</translation>
    </message>
    <message>
        <source>needs a whole bag</source>
        <translation>需要整个数据包</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>按时间</translation>
    </message>
    <message>
        <source>By speed</source>
        <translation>按速度</translation>
    </message>
    <message>
        <source>By localization quality</source>
        <translation>按定位质量</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>Reference map</source>
        <translation>参考地图</translation>
    </message>
    <message>
        <source>Whole map</source>
        <translation>整张地图</translation>
    </message>
    <message>
        <source>Zoomed out</source>
        <translation>缩小时</translation>
    </message>
    <message>
        <source>Occupied wins</source>
        <translation>占据优先</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Walls that are off</source>
        <translation>有偏差的墙</translation>
    </message>
</context>
<context>
    <name>session</name>
    <message>
        <source>Version %1</source>
        <translation>版本 %1</translation>
    </message>
    <message>
        <source>It arrived without a picture.</source>
        <translation>它到达时没有图像。</translation>
    </message>
    <message>
        <source>Picture %1</source>
        <translation>图像 %1</translation>
    </message>
    <message>
        <source>Its metadata says %1 x %2 cells, but its picture has %3 x %4. The size of the picture is used.</source>
        <translation>其元数据为 %1 x %2 个栅格，但其图像为 %3 x %4。采用图像的大小。</translation>
    </message>
    <message>
        <source>The rotation of its origin is not a number. It is shown without rotation.</source>
        <translation>其原点的旋转不是数字。不加旋转显示。</translation>
    </message>
    <message>
        <source>The cached copy was damaged. The map was read again from its picture.</source>
        <translation>缓存的副本已损坏。已从图像重新读取地图。</translation>
    </message>
    <message>
        <source>The robot sent another map, %1. It is not shown.</source>
        <translation>机器人发送了另一张地图 %1，不显示它。</translation>
    </message>
    <message>
        <source>It is used up, and no file can be written for the other submaps: %1. They stay in memory; free some disk space.</source>
        <translation>已用尽，且无法为其他子图写文件：%1。它们留在内存中；请腾出一些磁盘空间。</translation>
    </message>
    <message>
        <source>It cannot be loaded</source>
        <translation>无法加载</translation>
    </message>
    <message>
        <source>Version %1 is listed, but the robot sent version %2. It is shown.</source>
        <translation>列出的是版本 %1，但机器人发送了版本 %2。显示后者。</translation>
    </message>
    <message>
        <source>The robot lists an older version than the one shown.</source>
        <translation>机器人列出的版本比所显示的旧。</translation>
    </message>
</context>
<context>
    <name>shot</name>
    <message>
        <source>There is not enough memory for a picture of %1 x %2.</source>
        <translation>内存不足，无法生成 %1 x %2 的图像。</translation>
    </message>
    <message>
        <source>The picture cannot be encoded: %1.</source>
        <translation>图像无法编码：%1。</translation>
    </message>
</context>
<context>
    <name>submap</name>
    <message>
        <source>its pose contains numbers that are not finite</source>
        <translation>其位姿含有非有限的数字</translation>
    </message>
    <message>
        <source>its pose is more than 1,000 km from the map&apos;s origin</source>
        <translation>其位姿离地图原点超过 1,000 km</translation>
    </message>
    <message>
        <source>It is listed twice. It counts once.</source>
        <translation>它被列出两次，按一次计。</translation>
    </message>
    <message>
        <source>It is listed twice, differently. The highest version with a usable pose is used.</source>
        <translation>它被列出两次，且内容不同。采用位姿可用的最高版本。</translation>
    </message>
    <message>
        <source>its orientation is a zero quaternion</source>
        <translation>其方向是零四元数</translation>
    </message>
    <message>
        <source>Its position is unknown</source>
        <translation>其位置未知</translation>
    </message>
    <message>
        <source>The position of version %1 is unknown</source>
        <translation>版本 %1 的位置未知</translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps are listed without a valid version. They are asked for from time to time.</source>
        <translation>
            <numerusform>%1 个子图列出时没有有效版本。会不时请求它们。</numerusform>
        </translation>
    </message>
    <message>
        <source>its slice pose is not valid (a number that is not finite, or a zero quaternion)</source>
        <translation>其切片位姿无效（有数字不是有限值，或零四元数）</translation>
    </message>
    <message>
        <source>slice %1</source>
        <translation>切片 %1</translation>
    </message>
    <message>
        <source>Version %1 is broken</source>
        <translation>版本 %1 已损坏</translation>
    </message>
    <message>
        <source>Its version went back from %1 to %2. The newer picture stays unless the robot repeats it.</source>
        <translation>其版本从 %1 退回到 %2。除非机器人再次如此报告，否则保留较新的图像。</translation>
    </message>
</context>
<context>
    <name>window</name>
    <message>
        <source>AMCL and Nav2&apos;s costmaps will see %1 of %2 wall cells as walls, and %3 of %4 free cells as free.</source>
        <translation>AMCL 和 Nav2 的代价地图会把 %2 个墙栅格中的 %1 个视为墙，把 %4 个空闲栅格中的 %3 个视为空闲。</translation>
    </message>
    <message>
        <source>%1 wall cells will be free for them.</source>
        <translation>对它们来说，%1 个墙栅格会成为空闲。</translation>
    </message>
    <message>
        <source>Mode trinary without thresholds keeps them all.</source>
        <translation>不带阈值的 trinary 模式会全部保留。</translation>
    </message>
    <message>
        <source>The picture has only %1 of the %2 rows that its header says: %3 cells would be written as unknown, and %4 are there.</source>
        <translation>图像只有文件头所说 %2 行中的 %1 行：会有 %3 个栅格写为未知，现有 %4 个。</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>机器人(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>地图(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Colours of submaps</source>
        <translation>子图的颜色</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>Panel: %1</source>
        <translation>面板：%1</translation>
    </message>
    <message>
        <source> or </source>
        <translation> 或 </translation>
    </message>
    <message>
        <source>%1 has too many decimals: %2 is used.</source>
        <translation>%1 的小数位太多：取为 %2。</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 不是数字。</translation>
    </message>
    <message>
        <source>%1 is too small: at least %2.</source>
        <translation>%1 太小：至少为 %2。</translation>
    </message>
    <message>
        <source>%1 is too large: at most %2.</source>
        <translation>%1 太大：至多为 %2。</translation>
    </message>
    <message>
        <source>Close. To open it again, use the View menu</source>
        <translation>关闭。要再次打开，请用“视图”菜单</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>关闭 %1</translation>
    </message>
    <message>
        <source>… truncated: %1 in total</source>
        <translation>… 已截断：共 %1</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>已显示</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>已隐藏</translation>
    </message>
    <message>
        <source>updating</source>
        <translation>正在更新</translation>
    </message>
    <message>
        <source>queued</source>
        <translation>排队中</translation>
    </message>
    <message>
        <source>fetching</source>
        <translation>正在获取</translation>
    </message>
    <message>
        <source>no slice</source>
        <translation>没有切片</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>corrupt</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>no pose</source>
        <translation>没有位姿</translation>
    </message>
    <message>
        <source>offline</source>
        <translation>离线</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>正在连接</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>reconnecting</source>
        <translation>正在重新连接</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>connecting…</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>connected %1 ms</source>
        <translation>已连接 %1 ms</translation>
    </message>
    <message>
        <source> (attempt %1)</source>
        <translation> （第 %1 次）</translation>
    </message>
    <message>
        <source>no submaps</source>
        <translation>没有子图</translation>
    </message>
    <message>
        <source>%1 of %2 submaps</source>
        <translation>%1 / %2 个子图</translation>
    </message>
    <message>
        <source>without this slice</source>
        <translation>没有此切片</translation>
    </message>
    <message>
        <source>%1 to come</source>
        <translation>待获取 %1</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>（无名称）</translation>
    </message>
    <message>
        <source>the live map</source>
        <translation>实时地图</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Waiting for %1</source>
        <translation>正在等待 %1</translation>
    </message>
    <message>
        <source>Fetching %1</source>
        <translation>正在获取 %1</translation>
    </message>
    <message>
        <source>Reading %1 %2 %</source>
        <translation>正在读取 %1 %2%</translation>
    </message>
    <message>
        <source>%1, without its picture</source>
        <translation>%1，没有图像</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 失败</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>occupied %1 %</source>
        <translation>占据 %1%</translation>
    </message>
    <message>
        <source>free %1 %</source>
        <translation>空闲 %1%</translation>
    </message>
    <message numerus="yes">
        <source>%1 problems</source>
        <translation>
            <numerusform>%1 个问题</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 submaps</source>
        <translation>
            <numerusform>%1 个子图</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing for %1 s</source>
        <translation>已 %1 s 没有内容</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>无声</translation>
    </message>
    <message>
        <source>Maps and recordings (*.yaml *.yml *.png *.pgm *.bmp *.geojson *.pbstream *.mcap *.bag *.db3 *.zstd *.YAML *.PNG *.PGM *.BMP);;ROS maps (*.yaml *.yml);;Pictures (*.png *.pgm *.bmp);;Overlays (*.geojson);;SLAM states of Cartographer (*.pbstream);;Recordings (*.mcap *.bag *.db3 *.zstd metadata.yaml);;All files (*)</source>
        <translation>地图和录制文件 (*.yaml *.yml *.png *.pgm *.bmp *.geojson *.pbstream *.mcap *.bag *.db3 *.zstd *.YAML *.PNG *.PGM *.BMP);;ROS 地图 (*.yaml *.yml);;图像 (*.png *.pgm *.bmp);;覆盖物 (*.geojson);;Cartographer 的 SLAM 状态 (*.pbstream);;录制文件 (*.mcap *.bag *.db3 *.zstd metadata.yaml);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Stored maps</source>
        <translation>已存地图</translation>
    </message>
    <message>
        <source>Mappings</source>
        <translation>建图记录</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>id %1</source>
        <translation>编号 %1</translation>
    </message>
    <message>
        <source>bag</source>
        <translation>数据包</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>录制文件</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>information</source>
        <translation>信息</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红色</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙色</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄色</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿色</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>青色</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>紫色</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>粉色</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>电量</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>供电</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Wheels</source>
        <translation>车轮</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>PRESSED</source>
        <translation>已按下</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>released, can be pushed</source>
        <translation>已松开，可以推动</translation>
    </message>
    <message>
        <source>not pressed</source>
        <translation>未按下</translation>
    </message>
    <message>
        <source>SLAM</source>
        <translation>SLAM</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>可靠</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Lidar matching</source>
        <translation>激光雷达匹配</translation>
    </message>
    <message>
        <source>matched</source>
        <translation>已匹配</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>slipping</source>
        <translation>打滑</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>规划</translation>
    </message>
    <message>
        <source>action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>剩余</translation>
    </message>
    <message>
        <source>Stuck</source>
        <translation>卡住</translation>
    </message>
    <message>
        <source>Failure</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Global positioning</source>
        <translation>全局定位</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Confirmation</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>需要</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Jack</source>
        <translation>顶升</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重量</translation>
    </message>
    <message>
        <source>Self-check</source>
        <translation>自检</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>Towing</source>
        <translation>牵引</translation>
    </message>
    <message>
        <source>Cargo</source>
        <translation>货物</translation>
    </message>
    <message>
        <source>detected</source>
        <translation>已检测到</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>覆盖物</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>版本 %1</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>电源</translation>
    </message>
    <message>
        <source>Barcode</source>
        <translation>条码</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>note</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>建图</translation>
    </message>
    <message>
        <source>positioning</source>
        <translation>定位</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>未报告</translation>
    </message>
    <message>
        <source>, reliable</source>
        <translation>，可靠</translation>
    </message>
    <message>
        <source>, not reliable</source>
        <translation>，不可靠</translation>
    </message>
    <message>
        <source>Submap %1 is no longer listed.</source>
        <translation>子图 %1 已不在列表中。</translation>
    </message>
    <message>
        <source>FROZEN</source>
        <translation>冻结</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>活动</translation>
    </message>
    <message>
        <source>INC</source>
        <translation>增量</translation>
    </message>
    <message>
        <source>NEARBY</source>
        <translation>附近</translation>
    </message>
    <message>
        <source>No 2D map</source>
        <translation>没有 2D 地图</translation>
    </message>
    <message>
        <source>This robot provides point clouds. If it sends a map, the map appears automatically.</source>
        <translation>该机器人提供点云。如果它发送地图，地图会自动出现。</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>正在打开…</translation>
    </message>
    <message>
        <source>It has not reported any yet.</source>
        <translation>它尚未报告任何内容。</translation>
    </message>
    <message>
        <source>Double-click one under Maps.</source>
        <translation>在“地图”下双击一张。</translation>
    </message>
    <message>
        <source>This cannot be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>This map cannot be shown</source>
        <translation>无法显示此地图</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>正在加载 %1</translation>
    </message>
    <message>
        <source>Waiting for the robot&apos;s map</source>
        <translation>正在等待机器人的地图</translation>
    </message>
    <message>
        <source>It appears as soon as the robot sends it. Stored maps are listed under Maps.</source>
        <translation>机器人发送后即出现。已存地图列在“地图”下。</translation>
    </message>
    <message>
        <source>It appears as soon as the robot sends it.</source>
        <translation>机器人发送后即出现。</translation>
    </message>
    <message>
        <source>No map is open</source>
        <translation>没有打开的地图</translation>
    </message>
    <message>
        <source>Double-click one under Maps. This loads and changes nothing on the robot.</source>
        <translation>在“地图”下双击一张。这不在机器人上加载或改变任何内容。</translation>
    </message>
    <message>
        <source>The robot sends no map, and none is stored here.</source>
        <translation>机器人不发送地图，这里也没有存储地图。</translation>
    </message>
    <message>
        <source>No robot connected</source>
        <translation>未连接机器人</translation>
    </message>
    <message>
        <source>Connect to a robot by its address, try the simulated one, or open a map file (you can also drop it here).</source>
        <translation>按地址连接机器人，试用模拟机器人，或打开地图文件（也可以拖到这里）。</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>The robot refused the connection</source>
        <translation>机器人拒绝了连接</translation>
    </message>
    <message>
        <source>Cannot reach the robot</source>
        <translation>无法连接到机器人</translation>
    </message>
    <message>
        <source>Waiting for the list of submaps</source>
        <translation>正在等待子图列表</translation>
    </message>
    <message>
        <source>Connected to %1. It has not sent its list yet.</source>
        <translation>已连接到 %1，它尚未发送列表。</translation>
    </message>
    <message>
        <source>This robot lists no submaps</source>
        <translation>该机器人没有列出子图</translation>
    </message>
    <message>
        <source>They appear here as soon as the robot maps or localizes. Start mapping or load a map on the robot.</source>
        <translation>机器人建图或定位后即出现在这里。请在机器人上开始建图或加载地图。</translation>
    </message>
    <message numerus="yes">
        <source>Loading %1 submaps</source>
        <translation>
            <numerusform>正在加载 %1 个子图</numerusform>
        </translation>
    </message>
    <message>
        <source>All submaps are hidden</source>
        <translation>所有子图已隐藏</translation>
    </message>
    <message>
        <source>No submap has this slice</source>
        <translation>没有子图有此切片</translation>
    </message>
    <message>
        <source>. Show them again under Submaps.</source>
        <translation>。可在“子图”下重新显示。</translation>
    </message>
    <message>
        <source>. Choose another slice under Submaps.</source>
        <translation>。可在“子图”下选择另一切片。</translation>
    </message>
    <message>
        <source>None of the submaps can be drawn</source>
        <translation>没有一个子图可以绘制</translation>
    </message>
    <message>
        <source>. See Problems for the reasons.</source>
        <translation>。原因见“问题”。</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 has not been readable since %2, %3. Showing what was read last.</source>
        <translation>%1 自 %2 起无法读取，%3。显示最后读取的内容。</translation>
    </message>
    <message>
        <source>No connection since %1, %2. Showing the last data received.</source>
        <translation>自 %1 起没有连接，%2。显示最后收到的数据。</translation>
    </message>
    <message>
        <source>no whole map yet</source>
        <translation>还没有整张地图</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Submaps</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Submaps of %1</source>
        <translation>%1 的子图</translation>
    </message>
    <message>
        <source>Replay of %1 – %2</source>
        <translation>回放 %1 – %2</translation>
    </message>
    <message>
        <source>%1 | %2</source>
        <translation>%1 | %2</translation>
    </message>
    <message>
        <source>replay, not live</source>
        <translation>回放，不是实时</translation>
    </message>
    <message>
        <source>open</source>
        <translation>已打开</translation>
    </message>
    <message>
        <source>opening…</source>
        <translation>正在打开…</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>无法打开：%1</translation>
    </message>
    <message>
        <source>Background work</source>
        <translation>后台工作</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>忙碌</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Kept in memory, MiB</source>
        <translation>内存中保留，MiB</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>占用</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Cells of submaps</source>
        <translation>子图的栅格</translation>
    </message>
    <message>
        <source>Cells of submaps, prepared for drawing</source>
        <translation>子图的栅格（已备好绘制）</translation>
    </message>
    <message>
        <source>Tiles of submaps</source>
        <translation>子图的图块</translation>
    </message>
    <message>
        <source>Tiles of maps and costmaps</source>
        <translation>地图和代价地图的图块</translation>
    </message>
    <message>
        <source>Cells of maps, unpacked</source>
        <translation>地图的栅格（已解包）</translation>
    </message>
    <message>
        <source>Cells of maps by regions</source>
        <translation>分块地图的栅格</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Messages of the robot</source>
        <translation>机器人的消息</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>收到</translation>
    </message>
    <message>
        <source>Dropped for newer ones</source>
        <translation>因有更新的而丢弃</translation>
    </message>
    <message>
        <source>More than a second late</source>
        <translation>迟到一秒以上</translation>
    </message>
    <message>
        <source>Transforms, oldest first</source>
        <translation>变换，最旧的在前</translation>
    </message>
    <message>
        <source>Age, s</source>
        <translation>时长，s</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%2 中的 %1</translation>
    </message>
    <message>
        <source>Mouse and touchpad</source>
        <translation>鼠标和触摸板</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>drag, middle drag, Space+drag</source>
        <translation>拖动、中键拖动、空格+拖动</translation>
    </message>
    <message>
        <source>Pan (touchpad)</source>
        <translation>平移（触摸板）</translation>
    </message>
    <message>
        <source>two fingers</source>
        <translation>双指</translation>
    </message>
    <message>
        <source>arrows, Shift = faster</source>
        <translation>方向键，Shift = 更快</translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation>以光标为中心缩放</translation>
    </message>
    <message>
        <source>wheel, pinch</source>
        <translation>滚轮、捏合</translation>
    </message>
    <message>
        <source>Zoom finely</source>
        <translation>精细缩放</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+滚轮</translation>
    </message>
    <message>
        <source>Rotate the view</source>
        <translation>旋转视图</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Shift+滚轮</translation>
    </message>
    <message>
        <source>Centre and zoom in</source>
        <translation>居中并放大</translation>
    </message>
    <message>
        <source>double click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>Leave the tool or dialog</source>
        <translation>退出工具或对话框</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Keys and gestures</source>
        <translation>按键和手势</translation>
    </message>
    <message>
        <source>About mapwright</source>
        <translation>关于 mapwright</translation>
    </message>
    <message>
        <source>Shows what a mobile robot&apos;s SLAM sees, submap by submap, live.
Licensed under the Apache License 2.0.</source>
        <translation>逐个子图实时显示移动机器人的 SLAM 所知道的内容。
以 Apache License 2.0 许可。</translation>
    </message>
    <message>
        <source>Built with</source>
        <translation>构建所用</translation>
    </message>
    <message>
        <source>%1 in %2 is &quot;%3&quot;. It must be a whole number from %4 to %5, or 0 for the default. The default is used.</source>
        <translation>%2 中的 %1 为“%3”。它必须是 %4 到 %5 的整数，或 0 表示默认值。采用默认值。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言 (Language)</translation>
    </message>
    <message>
        <source>d MMM</source>
        <translation>M月d日</translation>
    </message>
    <message>
        <source>The window was busy for</source>
        <translation>窗口忙碌时长</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>less than %1 ms</source>
        <translation>小于 %1 ms</translation>
    </message>
    <message>
        <source>%1 ms and longer</source>
        <translation>%1 ms 及以上</translation>
    </message>
    <message>
        <source>Longest, ms (%1)</source>
        <translation>最长，ms（%1）</translation>
    </message>
    <message>
        <source>Commit %1</source>
        <translation>提交 %1</translation>
    </message>
    <message>
        <source>Qt %1, compiled against %2</source>
        <translation>Qt %1，编译时为 %2</translation>
    </message>
    <message>
        <source>Commit %1
Qt %2, compiled against %3</source>
        <translation>提交 %1
Qt %2，编译时为 %3</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Version, commit and libraries as a text</source>
        <translation>版本、提交号和各库，以文本形式</translation>
    </message>
    <message>
        <source>Processors: %1</source>
        <translation>处理器：%1</translation>
    </message>
    <message>
        <source>Display: %1</source>
        <translation>显示：%1</translation>
    </message>
    <message>
        <source>Screen: %1 × %2, scale %3, %4 Hz</source>
        <translation>屏幕：%1 × %2，缩放 %3，%4 Hz</translation>
    </message>
    <message>
        <source>Problems (the last %1 of %2)</source>
        <translation>问题（最近 %1 个，共 %2 个）</translation>
    </message>
    <message>
        <source>Left out: addresses and names of robots (robot-1, robot-2 …), secrets, home folders, the names of user and computer. Names of maps, files and topics are in it, and names of one or two letters.</source>
        <translation>已略去：机器人的地址和名称 (robot-1、robot-2…)、密钥、主文件夹、用户名和计算机名。地图、文件和话题的名称仍在其中，一两个字母的名称也是。</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>分块</translation>
    </message>
    <message>
        <source>reconnecting%1</source>
        <translation>正在重新连接%1</translation>
    </message>
    <message>
        <source>reconnecting now%1</source>
        <translation>现在重新连接%1</translation>
    </message>
    <message>
        <source>reconnecting in %1 s%2</source>
        <translation>%1 s 后重新连接%2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message numerus="yes">
        <source>%1 more are not listed.</source>
        <translation>
            <numerusform>还有 %1 个未列出。</numerusform>
        </translation>
    </message>
    <message>
        <source>Only %1 letters fit. The rest was left out.</source>
        <translation>最多只能输入 %1 个字符，其余部分已略去。</translation>
    </message>
</context>
<context>
    <name>wire</name>
    <message numerus="yes">
        <source>%1 rows without an id were left out.</source>
        <translation>
            <numerusform>%1 行没有编号，已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>the robot&apos;s answer is not a map</source>
        <translation>机器人的应答不是地图</translation>
    </message>
    <message>
        <source>The robot&apos;s list of points is not a list.</source>
        <translation>机器人的点列表不是列表。</translation>
    </message>
    <message numerus="yes">
        <source>%1 points without a position were left out.</source>
        <translation>
            <numerusform>%1 个点没有位置，已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>Two waypoints have the id %1.</source>
        <translation>两个路径点的编号都是 %1。</translation>
    </message>
    <message>
        <source>The robot accepted the deletion, but still lists the map.</source>
        <translation>机器人接受了删除，但仍列出该地图。</translation>
    </message>
    <message>
        <source>The robot accepted the new map, but does not list it.</source>
        <translation>机器人接受了新地图，但没有列出它。</translation>
    </message>
    <message>
        <source>The robot accepted it, but is not mapping.</source>
        <translation>机器人已接受，但没有在建图。</translation>
    </message>
    <message>
        <source>The robot is mapping already. Stop or discard that mapping first.</source>
        <translation>机器人已在建图。请先停止或放弃那次建图。</translation>
    </message>
    <message>
        <source>The robot accepted it, but is still mapping.</source>
        <translation>机器人已接受，但仍在建图。</translation>
    </message>
    <message>
        <source>It has no fields x and y, or their type is unknown.</source>
        <translation>它没有字段 x 和 y，或其类型未知。</translation>
    </message>
</context>
</TS>
