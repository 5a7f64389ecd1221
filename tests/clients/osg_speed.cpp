// osg_speed FOLDER OUT: how fast OpenSceneGraph reads and writes the OpenFlight files that the formats' example `speed`
// made. Prints for each, between tabs: format, program, file, seconds to write and to read (the median of seven rounds).
//
// g++ -O2 -o osg_speed osg_speed.cpp -losg -losgDB -losgUtil -lOpenThreads

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <osg/Geometry>
#include <osg/Version>
#include <osg/TriangleFunctor>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

namespace {

struct Count {
    unsigned triangles = 0;
    void operator()(const osg::Vec3&, const osg::Vec3&, const osg::Vec3&, bool = false) { triangles++; }
};

struct Survey : osg::NodeVisitor {
    unsigned triangles = 0;
    Survey() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Drawable& drawable) override {
        osg::TriangleFunctor<Count> count;
        drawable.accept(count);
        triangles += count.triangles;
    }
};

double median(const std::function<void()>& work) {
    std::vector<double> times;
    work();
    for (int i = 0; i < 7; i++) {
        // The reader keeps what it read once, whatever its options say.
        osgDB::Registry::instance()->clearObjectCache();
        const auto start = std::chrono::steady_clock::now();
        work();
        times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(times.begin(), times.end());
    return times[3];
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const std::string folder = argv[1], out = argv[2];
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->setObjectCacheHint(osgDB::Options::CACHE_NONE);
    for (const std::string kind : {"faces", "meshes"}) {
        const std::string in = folder + "/" + kind + ".flt", made = out + "/" + kind + ".flt";
        osg::ref_ptr<osg::Node> node;
        const double read = median([&] { node = osgDB::readRefNodeFile(in, options.get()); });
        Survey survey;
        if (node) node->accept(survey);
        std::cerr << kind << ": " << survey.triangles << " triangles\n";
        if (!survey.triangles) continue;
        const double write = median([&] { osgDB::writeNodeFile(*node, made, options.get()); });
        std::cout << "OpenFlight " << kind << "\tOpenSceneGraph " << osgGetVersion() << "\t" << made << "\t" << write << "\t"
                  << read << "\n";
    }
}
