// What its signals carry is complete here.
#include "robot/robot.h"

#include "map/live_topics.h"
#include "moc_robot.cpp"
