// What the public client of rosbridge sees of the simulated robot. Arguments: the address of the server, the
// dialect (ros1 or ros2), and the folder with node_modules. Ends with 0, or with a line that says what is wrong.
import { pathToFileURL } from 'node:url';
import path from 'node:path';

const [url, dialect, modules] = process.argv.slice(2);
const ROSLIB = await import(pathToFileURL(path.join(modules, "node_modules", "roslib", "dist", "RosLib.js")).href);

const type = (name, kind = 'msg') => (dialect === 'ros2' ? name.replace('/', `/${kind}/`) : name);
const within = (seconds, what, work) =>
  Promise.race([
    new Promise(work),
    new Promise((_, fail) => setTimeout(() => fail(new Error(`${what}: nothing within ${seconds} s`)), seconds * 1000)),
  ]);
const check = (fine, what) => {
  if (!fine) throw new Error(what);
};

const ros = new ROSLIB.Ros({ url });
const call = (name, serviceType, request) =>
  within(20, name, (done, fail) =>
    new ROSLIB.Service({ ros, name, serviceType }).callService(request, done, (why) => fail(new Error(`${name}: ${why}`))));
const first = (name, messageType, options = {}) =>
  within(20, name, (done) => {
    const topic = new ROSLIB.Topic({ ros, name, messageType, ...options });
    topic.subscribe((message) => {
      topic.unsubscribe();
      done(message);
    });
  });

async function all() {
  await within(20, 'connection', (done, fail) => {
    ros.on('connection', done);
    ros.on('error', (error) => fail(error instanceof Error ? error : new Error(String(error))));
  });

  const told = await within(20, '/rosapi/topics', (done, fail) => ros.getTopics(done, (why) => fail(new Error(why))));
  const map = told.topics.indexOf('/map');
  check(map >= 0 && told.types[map] === type('nav_msgs/OccupancyGrid'), `/map is of type ${told.types[map]}`);
  const services = await within(20, '/rosapi/services', (done, fail) => ros.getServices(done, (why) => fail(new Error(why))));
  check(services.includes('/map_manager/create_waypoint'), 'there is no map manager');

  const plain = await first('/map', type('nav_msgs/OccupancyGrid'));
  check(plain.data.length === plain.info.width * plain.info.height && plain.data.length > 0,
        `/map has ${plain.data.length} cells, but is ${plain.info.width} x ${plain.info.height}`);
  for (const compression of ['png', 'cbor']) {
    const packed = await first('/map', type('nav_msgs/OccupancyGrid'), { compression });
    check(packed.data.length === plain.data.length && plain.data.every((cell, i) => packed.data[i] === cell),
          `/map by ${compression} is another`);
  }
  const tf = await first('/tf', type('tf2_msgs/TFMessage'), { throttle_rate: 100, queue_length: 1 });
  check(tf.transforms.every((one) => Number.isFinite(one.transform.translation.x)), '/tf has no numbers');
  check((dialect === 'ros2' ? 'nanosec' : 'nsecs') in tf.transforms[0].header.stamp, '/tf has times of the other ROS');

  const given = await call(dialect === 'ros2' ? '/map_server/map' : '/static_map', type('nav_msgs/GetMap', 'srv'), {});
  check(given.map.data.length === plain.data.length, 'GetMap gives another map');

  const current = await first('/map_manager/current_map_info', type('kabam_msgs/MapInfo'));
  const waypoint = {
    id: '', name: 'roslib', frame_id: 'map', map_id: current.map_id, waypoint_tags: ['tried'],
    pose: { position: { x: 1, y: 2, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } },
  };
  const shown = within(20, 'the new waypoint', (done) => {
    const topic = new ROSLIB.Topic({ ros, name: '/map_manager/current_map_waypoints', messageType: type('kabam_msgs/MapWaypointList') });
    topic.subscribe((list) => list.waypoints.some((one) => one.name === 'roslib') && done());
  });
  const made = await call('/map_manager/create_waypoint', type('kabam_msgs/ManageWaypoint', 'srv'),
                          { waypoint_info: waypoint, delete_waypoint: false });
  check(made.result === 0 && made.waypoint_response.id, `create_waypoint answers ${made.result}`);
  await shown;

  const refused = await call('/no/such', 'std_srvs/Empty', {}).then(() => '', (error) => error.message);
  check(refused.includes('does not exist'), `an unknown service answers "${refused}"`);
}

all().then(
  () => process.exit(0),
  (error) => {
    console.error(error.message);
    process.exit(1);
  });
