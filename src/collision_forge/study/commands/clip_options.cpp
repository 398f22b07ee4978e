#include "collision_forge/study/commands/clip_options.h"

#include "collision_forge/app/options.h"

namespace forge {

void addDataroot(CLI::App& app, std::string& dataroot) {
  app.add_option("--source,--dataroot", dataroot, "nuScenes root, used for maps/expansion")
      ->required()
      ->check(CLI::ExistingDirectory);
}

CLI::Option* addCollide(CLI::App& app, std::string& collide) {
  return app.add_option("--collide", collide, "folder of COLLIDE clips, contains trajectory/SPLIT")
      ->check(CLI::ExistingDirectory);
}

CLI::Option* addSplit(CLI::App& app, std::string& split, CLI::Option* collide) {
  return app.add_option("--split", split, "split of the clips of --collide")
      ->transform(oneOf({"train", "val", "test"}))
      ->capture_default_str()
      ->needs(collide);
}

void addLimit(CLI::App& app, std::size_t& limit, CLI::Option* collide) {
  app.add_option("--limit", limit, "use only the first N clips of --collide; 0: all")
      ->capture_default_str()
      ->needs(collide);
}

}  // namespace forge
