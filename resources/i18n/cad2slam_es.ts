<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES">
<context>
    <name>Engine</name>
    <message>
        <source>Drawing the map was cancelled, it is not written</source>
        <translation>Se canceló el dibujo del mapa, que no se ha escrito</translation>
    </message>
    <message>
        <source>anchor %1</source>
        <translation>ancla %1</translation>
    </message>
    <message>
        <source>projector</source>
        <translation>proyector</translation>
    </message>
    <message>
        <source>its number is used twice</source>
        <translation>su número se usa dos veces</translation>
    </message>
    <message>
        <source>its coordinates are not finite numbers</source>
        <translation>sus coordenadas no son números finitos</translation>
    </message>
    <message>
        <source>its point lies %1 outside the blueprint; correct or disable it</source>
        <translation>su punto está %1 fuera del plano; corrija o apague el ancla</translation>
    </message>
    <message>
        <source>its point lies %1 outside the SLAM map; correct or disable it</source>
        <translation>su punto está %1 fuera del mapa SLAM; corrija o apague el ancla</translation>
    </message>
    <message>
        <source>anchors %1 and %2 share a blueprint point but are %3 apart in the SLAM map; correct or disable one of them</source>
        <translation>las anclas %1 y %2 comparten un punto del plano, pero en el mapa SLAM están a %3; corrija o apague una de ellas</translation>
    </message>
    <message>
        <source>anchors %1 and %2 share a SLAM map point but are %3 apart in the blueprint; correct or disable one of them</source>
        <translation>las anclas %1 y %2 comparten un punto del mapa SLAM, pero en el plano están a %3; corrija o apague una de ellas</translation>
    </message>
    <message>
        <source>no pair of corresponding points to align with</source>
        <translation>no hay ningún par de puntos correspondientes con el que alinear</translation>
    </message>
    <message>
        <source>a pair of corresponding points is not finite</source>
        <translation>un par de puntos correspondientes no es finito</translation>
    </message>
    <message>
        <source>all points are at one place, so rotation and scale are unknown</source>
        <translation>todos los puntos están en un mismo lugar, así que no se conocen el giro ni la escala</translation>
    </message>
    <message>
        <source>the points do not determine a rotation and a scale</source>
        <translation>los puntos no determinan un giro y una escala</translation>
    </message>
    <message>
        <source>the resolution of a map must be a positive number of metres per pixel</source>
        <translation>la resolución de un mapa debe ser un número positivo de metros por píxel</translation>
    </message>
    <message>
        <source>a map must be at least one pixel wide and high</source>
        <translation>un mapa debe tener al menos un píxel de ancho y de alto</translation>
    </message>
    <message>
        <source>the origin of a map must be three finite numbers</source>
        <translation>el origen de un mapa debe constar de tres números finitos</translation>
    </message>
    <message>
        <source>the cell size must be a positive number of metres</source>
        <translation>el tamaño de celda debe ser un número positivo de metros</translation>
    </message>
    <message>
        <source>cells of %1 m give a mesh of more than %2 nodes; choose a larger cell size</source>
        <translation>con celdas de %1 m la malla tiene más de %2 nodos; elija un tamaño de celda mayor</translation>
    </message>
    <message>
        <source>the blueprint has no free pixel, so there is nothing to mesh</source>
        <translation>el plano no tiene ningún píxel libre, así que no hay nada que mallar</translation>
    </message>
    <message>
        <source>the mesh needs a finite, positive cell size and a finite origin</source>
        <translation>la malla necesita un tamaño de celda finito y positivo y un origen finito</translation>
    </message>
    <message>
        <source>the mesh has no node</source>
        <translation>la malla no tiene ningún nodo</translation>
    </message>
    <message>
        <source>the mesh has %1 centres for %2 tiles</source>
        <translation>la malla tiene %1 centros para %2 teselas</translation>
    </message>
    <message>
        <source>the mesh has a node at no finite place</source>
        <translation>la malla tiene un nodo en un lugar que no es finito</translation>
    </message>
    <message>
        <source>the mesh has two nodes on one tile</source>
        <translation>la malla tiene dos nodos en una misma tesela</translation>
    </message>
    <message>
        <source>there is no enabled anchor; at least one pair of corresponding points is needed</source>
        <translation>no hay ninguna ancla activa; se necesita al menos un par de puntos correspondientes</translation>
    </message>
    <message>
        <source>the scale must be a positive number</source>
        <translation>la escala debe ser un número positivo</translation>
    </message>
    <message>
        <source>the mesh of %1 nodes is too large for the memory of this computer; choose a larger cell size</source>
        <translation>la malla de %1 nodos es demasiado grande para la memoria de este equipo; elija un tamaño de celda mayor</translation>
    </message>
    <message>
        <source>the optimisation was cancelled</source>
        <translation>la optimización se canceló</translation>
    </message>
    <message>
        <source>the optimisation found no finite minimum; check the anchors and the weights</source>
        <translation>la optimización no halló un mínimo finito; compruebe las anclas y los pesos</translation>
    </message>
    <message>
        <source>the anchors do not determine the mesh; add anchors or enable some</source>
        <translation>las anclas no determinan la malla; añada anclas o active algunas</translation>
    </message>
    <message>
        <source>One place is anchored: only the translation is known; add an anchor far away from it.</source>
        <translation>Hay un solo lugar anclado: solo se conoce la traslación; añada un ancla lejos de él.</translation>
    </message>
    <message>
        <source>Two places are anchored: only rotation and translation are known; a third anchor lets the mesh bend.</source>
        <translation>Hay dos lugares anclados: solo se conocen el giro y la traslación; con una tercera ancla la malla puede doblarse.</translation>
    </message>
    <message>
        <source>The optimisation stopped after %1 iterations before it had converged.</source>
        <translation>La optimización se detuvo tras %1 iteraciones, antes de converger.</translation>
    </message>
    <message>
        <source>The planner needs a positive step, and a radius, clearance and clearance cost that are not negative</source>
        <translation>El planificador necesita un paso positivo y un radio, una holgura y un coste de holgura que no sean negativos</translation>
    </message>
    <message>
        <source>The start %1 lies outside of the map</source>
        <translation>El inicio %1 está fuera del mapa</translation>
    </message>
    <message>
        <source>The goal %1 lies outside of the map</source>
        <translation>La meta %1 está fuera del mapa</translation>
    </message>
    <message>
        <source>The start %1 lies inside a wall</source>
        <translation>El inicio %1 está dentro de una pared</translation>
    </message>
    <message>
        <source>The goal %1 lies inside a wall</source>
        <translation>La meta %1 está dentro de una pared</translation>
    </message>
    <message>
        <source>The start %1 lies where the map is unknown</source>
        <translation>El inicio %1 está donde el mapa es desconocido</translation>
    </message>
    <message>
        <source>The goal %1 lies where the map is unknown</source>
        <translation>La meta %1 está donde el mapa es desconocido</translation>
    </message>
    <message>
        <source>The start %1 lies nearer to a wall than the radius of the robot</source>
        <translation>El inicio %1 está más cerca de una pared que el radio del robot</translation>
    </message>
    <message>
        <source>The goal %1 lies nearer to a wall than the radius of the robot</source>
        <translation>La meta %1 está más cerca de una pared que el radio del robot</translation>
    </message>
    <message>
        <source>No path leads from %1 to %2</source>
        <translation>Ningún camino lleva de %1 a %2</translation>
    </message>
    <message>
        <source>The step between two poses of the path is too small for its length</source>
        <translation>El paso entre dos poses del camino es demasiado pequeño para su longitud</translation>
    </message>
    <message>
        <source>the projector has no finite, positive cell size and finite origin</source>
        <translation>el proyector no tiene un tamaño de celda finito y positivo y un origen finito</translation>
    </message>
    <message>
        <source>the projector has no finite, positive scale</source>
        <translation>el proyector no tiene una escala finita y positiva</translation>
    </message>
    <message>
        <source>the radius of the projector is not between 0 and 1000 cells</source>
        <translation>el radio del proyector no está entre 0 y 1000 celdas</translation>
    </message>
    <message>
        <source>the projector&apos;s node arrays differ in length</source>
        <translation>las listas de nodos del proyector difieren en longitud</translation>
    </message>
    <message>
        <source>the projector has no node</source>
        <translation>el proyector no tiene ningún nodo</translation>
    </message>
    <message>
        <source>the projector has too many nodes</source>
        <translation>el proyector tiene demasiados nodos</translation>
    </message>
    <message>
        <source>the projector has two nodes on one tile</source>
        <translation>el proyector tiene dos nodos en una misma tesela</translation>
    </message>
    <message>
        <source>the projector has an edge to a node that does not exist</source>
        <translation>el proyector tiene una arista hacia un nodo que no existe</translation>
    </message>
    <message>
        <source>the projector has an anchor that is not finite</source>
        <translation>el proyector tiene un ancla que no es finita</translation>
    </message>
    <message>
        <source>the names and notes of the projector are too long to be written</source>
        <translation>los nombres y las notas del proyector son demasiado largos para escribirlos</translation>
    </message>
    <message>
        <source>node %1 of the projector lies on a tile outside any building</source>
        <translation>el nodo %1 del proyector está en una tesela fuera de cualquier edificio</translation>
    </message>
    <message>
        <source>node %1 of the projector is not finite</source>
        <translation>el nodo %1 del proyector no es finito</translation>
    </message>
    <message>
        <source>node %1 of the projector is stretched beyond reason</source>
        <translation>el nodo %1 del proyector está estirado sin medida</translation>
    </message>
    <message>
        <source>node %1 of the projector does not lie on its tile</source>
        <translation>el nodo %1 del proyector no está en su tesela</translation>
    </message>
    <message>
        <source>the picture is not as large as its frame says</source>
        <translation>la imagen no es tan grande como dice su marco</translation>
    </message>
    <message>
        <source>pictures wider or higher than %1 pixels cannot be warped; choose a coarser resolution</source>
        <translation>no se pueden deformar imágenes de más de %1 píxeles de ancho o de alto; elija una resolución más gruesa</translation>
    </message>
    <message>
        <source>the resolution must be a positive number of metres per pixel</source>
        <translation>la resolución debe ser un número positivo de metros por píxel</translation>
    </message>
    <message>
        <source>the projector draws nothing of this picture</source>
        <translation>el proyector no dibuja nada de esta imagen</translation>
    </message>
    <message>
        <source>the warped picture would be wider than a million pixels; choose a coarser resolution</source>
        <translation>la imagen deformada tendría más de un millón de píxeles de ancho; elija una resolución más gruesa</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>no existe ese archivo</translation>
    </message>
    <message>
        <source>cannot be opened (%1)</source>
        <translation>no se puede abrir (%1)</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>no se puede leer (%1)</translation>
    </message>
    <message>
        <source>cannot be written (%1)</source>
        <translation>no se puede escribir (%1)</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>no se puede escribir: %1</translation>
    </message>
    <message>
        <source>a file name is missing</source>
        <translation>falta un nombre de archivo</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>no es un archivo normal</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>no es un archivo normal</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>es una carpeta, no un archivo</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes that are read</source>
        <translation>es mayor que los %1 bytes que se leen</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>está vacío</translation>
    </message>
    <message>
        <source>ends too early</source>
        <translation>termina demasiado pronto</translation>
    </message>
    <message>
        <source>was cut off while it was read</source>
        <translation>se cortó mientras se leía</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Permiso denegado</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Operación no permitida</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>No queda espacio en el dispositivo</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Se ha superado la cuota de disco</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Sistema de archivos de solo lectura</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Archivo demasiado grande</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Nombre de archivo demasiado largo</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>No existe el archivo o la carpeta</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Es una carpeta</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>No es una carpeta</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>Demasiados niveles de enlaces simbólicos</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Demasiados archivos abiertos</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Error de entrada/salida</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Dispositivo o recurso ocupado</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>El archivo de la unidad de red ya no es válido</translation>
    </message>
    <message>
        <source>is no image that can be read: PGM, PNG, JPG, BMP and TIFF can</source>
        <translation>no es una imagen que se pueda leer: sí PGM, PNG, JPG, BMP y TIFF</translation>
    </message>
    <message>
        <source>is cut off: the image is not complete</source>
        <translation>está cortado: la imagen no está completa</translation>
    </message>
    <message>
        <source>is an image of %1 x %2 pixels</source>
        <translation>es una imagen de %1 x %2 píxeles</translation>
    </message>
    <message>
        <source>is an image of %1 x %2 pixels; at most 30000 x 30000 are read</source>
        <translation>es una imagen de %1 x %2 píxeles; se leen como máximo 30000 x 30000</translation>
    </message>
    <message>
        <source>claims %1 x %2 pixels, which its %3 bytes cannot hold</source>
        <translation>declara %1 x %2 píxeles, que no caben en sus %3 bytes</translation>
    </message>
    <message>
        <source>is no image: its PNM header does not say width, height and largest value</source>
        <translation>no es una imagen: su cabecera PNM no indica ancho, alto y valor máximo</translation>
    </message>
    <message>
        <source>is damaged: wrong checksum in the PNG chunk at byte %1</source>
        <translation>está dañado: suma de control errónea en el bloque PNG del byte %1</translation>
    </message>
    <message>
        <source>is damaged: no JPEG segment at byte %1</source>
        <translation>está dañado: no hay segmento JPEG en el byte %1</translation>
    </message>
    <message>
        <source>is damaged: empty JPEG segment at byte %1</source>
        <translation>está dañado: segmento JPEG vacío en el byte %1</translation>
    </message>
    <message>
        <source>is damaged: a JPEG without a frame header</source>
        <translation>está dañado: un JPEG sin cabecera de imagen</translation>
    </message>
    <message>
        <source>is no image: its TIFF directory has too many entries</source>
        <translation>no es una imagen: su directorio TIFF tiene demasiadas entradas</translation>
    </message>
    <message>
        <source>is no image: its TIFF directory does not say width and height</source>
        <translation>no es una imagen: su directorio TIFF no indica ancho y alto</translation>
    </message>
    <message>
        <source>is a damaged image</source>
        <translation>es una imagen dañada</translation>
    </message>
    <message>
        <source>is a damaged image: its size is not the one its header says</source>
        <translation>es una imagen dañada: su tamaño no es el que dice su cabecera</translation>
    </message>
    <message>
        <source>is too large an image for the memory of this machine</source>
        <translation>es una imagen demasiado grande para la memoria de este equipo</translation>
    </message>
    <message>
        <source>is an image of an unusual kind: 8 or 16 bit grey or colour can be read</source>
        <translation>es una imagen de un tipo inusual: se leen grises o color de 8 o 16 bits</translation>
    </message>
    <message>
        <source>is an image of an unusual kind: grey, colour, or colour with alpha can be read</source>
        <translation>es una imagen de un tipo inusual: se leen grises, color o color con alfa</translation>
    </message>
    <message>
        <source>is an image with neither 8 nor 16 bits a sample</source>
        <translation>es una imagen que no tiene ni 8 ni 16 bits por muestra</translation>
    </message>
    <message>
        <source>pictures are written as .pgm or .png, not %1</source>
        <translation>las imágenes se escriben como .pgm o .png, no como %1</translation>
    </message>
    <message>
        <source>a .pgm holds grey of 8 or 16 bits only; write a .png instead</source>
        <translation>un .pgm solo contiene grises de 8 o 16 bits; escriba un .png</translation>
    </message>
    <message>
        <source>a .png holds grey or colour of 8 or 16 bits only</source>
        <translation>un .png solo contiene grises o color de 8 o 16 bits</translation>
    </message>
    <message>
        <source>the image cannot be encoded</source>
        <translation>la imagen no se puede codificar</translation>
    </message>
    <message>
        <source>the image of a map must be a file name without folders</source>
        <translation>la imagen de un mapa debe ser un nombre de archivo sin carpetas</translation>
    </message>
    <message>
        <source>is a damaged image: %1</source>
        <translation>es una imagen dañada: %1</translation>
    </message>
    <message>
        <source>there is no room for the temporary tiles of this image</source>
        <translation>no hay sitio para las teselas temporales de esta imagen</translation>
    </message>
    <message>
        <source>Grey 205, which map_saver writes for unknown, counts as free with free_thresh %1; 0.196 would keep it unknown.</source>
        <translation>El gris 205, que map_saver escribe para lo desconocido, cuenta como libre con free_thresh %1; con 0.196 seguiría desconocido.</translation>
    </message>
    <message>
        <source>%1 pixels were read as %2 read them; %3 would read them differently.</source>
        <translation>%1 píxeles se leyeron como los leen %2; %3 los leerían de otro modo.</translation>
    </message>
    <message>
        <source>ROS 2 jazzy and later</source>
        <translation>ROS 2 Jazzy y posteriores</translation>
    </message>
    <message>
        <source>ROS 1 and ROS 2 up to humble</source>
        <translation>ROS 1 y ROS 2 hasta Humble</translation>
    </message>
    <message>
        <source>is too large for a map YAML</source>
        <translation>es demasiado grande para el YAML de un mapa</translation>
    </message>
    <message>
        <source>is not valid YAML (%1)</source>
        <translation>no es YAML válido (%1)</translation>
    </message>
    <message>
        <source>aliases (*name) are not read</source>
        <translation>los alias (*name) no se leen</translation>
    </message>
    <message>
        <source>the values are nested too deeply</source>
        <translation>los valores están anidados demasiado hondo</translation>
    </message>
    <message>
        <source>a map needs lines such as `image: map.pgm`</source>
        <translation>un mapa necesita líneas como `image: map.pgm`</translation>
    </message>
    <message>
        <source>a key must be a word</source>
        <translation>una clave debe ser una palabra</translation>
    </message>
    <message>
        <source>holds no map: image and resolution are missing</source>
        <translation>no contiene un mapa: faltan image y resolution</translation>
    </message>
    <message>
        <source>the key %1 is missing</source>
        <translation>falta la clave %1</translation>
    </message>
    <message>
        <source>the key %1 already stands in line %2</source>
        <translation>la clave %1 ya está en la línea %2</translation>
    </message>
    <message>
        <source>%1 must be one value, not a list</source>
        <translation>%1 debe ser un solo valor, no una lista</translation>
    </message>
    <message>
        <source>%1 must be a number from %2 to %3, not %4</source>
        <translation>%1 debe ser un número de %2 a %3, no %4</translation>
    </message>
    <message>
        <source>image must name an image file</source>
        <translation>image debe nombrar un archivo de imagen</translation>
    </message>
    <message>
        <source>image is no file name: %1</source>
        <translation>image no es un nombre de archivo: %1</translation>
    </message>
    <message>
        <source>origin must be a list of three numbers [x, y, yaw]</source>
        <translation>origin debe ser una lista de tres números [x, y, yaw]</translation>
    </message>
    <message>
        <source>origin holds %1, no finite number</source>
        <translation>origin contiene %1, que no es un número finito</translation>
    </message>
    <message>
        <source>free_thresh must not be above occupied_thresh, which is %1</source>
        <translation>free_thresh no debe superar occupied_thresh, que es %1</translation>
    </message>
    <message>
        <source>negate must be 0 or 1, not %1</source>
        <translation>negate debe ser 0 o 1, no %1</translation>
    </message>
    <message>
        <source>mode must be trinary, scale or raw, not %1</source>
        <translation>mode debe ser trinary, scale o raw, no %1</translation>
    </message>
    <message>
        <source>The yaw of origin is not a number and was read as 0.</source>
        <translation>El giro de origin no es un número y se leyó como 0.</translation>
    </message>
    <message>
        <source>The map is turned by a yaw of %1 rad in origin: RViz shows that, navigation and localisation of ROS ignore it.</source>
        <translation>El mapa está girado %1 rad en origin: RViz lo muestra, la navegación y la localización de ROS lo ignoran.</translation>
    </message>
    <message>
        <source>holds no anchors</source>
        <translation>no contiene anclas</translation>
    </message>
    <message>
        <source>is UTF-16 text; save it as UTF-8</source>
        <translation>es texto UTF-16; guárdelo como UTF-8</translation>
    </message>
    <message>
        <source>the column %1 stands twice in the header</source>
        <translation>la columna %1 está dos veces en el encabezado</translation>
    </message>
    <message>
        <source>the header has no column %1, which anchors need</source>
        <translation>el encabezado no tiene la columna %1, que las anclas necesitan</translation>
    </message>
    <message>
        <source>more than %1 lines are no anchors</source>
        <translation>más de %1 líneas no son anclas</translation>
    </message>
    <message>
        <source>no line can be read as an anchor; the first one %1</source>
        <translation>ninguna línea se puede leer como ancla; la primera: %1</translation>
    </message>
    <message>
        <source>has %1 of at least %2 fields</source>
        <translation>tiene %1 de al menos %2 campos</translation>
    </message>
    <message>
        <source>has too few fields</source>
        <translation>tiene muy pocos campos</translation>
    </message>
    <message>
        <source>has a quote that is never closed</source>
        <translation>tiene una comilla que nunca se cierra</translation>
    </message>
    <message>
        <source>has text behind a closing quote</source>
        <translation>tiene texto tras una comilla de cierre</translation>
    </message>
    <message>
        <source>the id %1 is not a whole number</source>
        <translation>la id %1 no es un número entero</translation>
    </message>
    <message>
        <source>the id %1 is not from 0 to %2</source>
        <translation>la id %1 no está entre 0 y %2</translation>
    </message>
    <message>
        <source>the id %1 already stands in line %2</source>
        <translation>la id %1 ya está en la línea %2</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 no es un número finito</translation>
    </message>
    <message>
        <source>%1 is too large for a coordinate</source>
        <translation>%1 es demasiado grande para una coordenada</translation>
    </message>
    <message>
        <source>enabled is %1, not 1 or 0</source>
        <translation>enabled es %1, no 1 o 0</translation>
    </message>
    <message>
        <source>enable is %1, not 1 or 0</source>
        <translation>enable es %1, no 1 o 0</translation>
    </message>
    <message>
        <source>holds no &quot;CorrespondenceAnchor&quot;</source>
        <translation>no contiene ningún &quot;CorrespondenceAnchor&quot;</translation>
    </message>
    <message>
        <source>more than %1 objects are no anchors</source>
        <translation>más de %1 objetos no son anclas</translation>
    </message>
    <message>
        <source>no anchor can be read: %1</source>
        <translation>no se puede leer ninguna ancla: %1</translation>
    </message>
    <message>
        <source>expected %1 instead of %2</source>
        <translation>se esperaba %1 en lugar de %2</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>un número finito</translation>
    </message>
    <message>
        <source>_cad_point or _slam_point</source>
        <translation>_cad_point o _slam_point</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>el final del archivo</translation>
    </message>
    <message>
        <source>holds points of QGIS, which are pixels of two images; import it in the app with both of them loaded and export the anchors from there</source>
        <translation>contiene puntos de QGIS, que son píxeles de dos imágenes; impórtelo en la aplicación con ambas cargadas y exporte las anclas desde allí</translation>
    </message>
    <message>
        <source>Points of QGIS are pixels: load both images first</source>
        <translation>Los puntos de QGIS son píxeles: cargue primero ambas imágenes</translation>
    </message>
    <message>
        <source>has no header with the columns mapX, mapY, sourceX and sourceY</source>
        <translation>no tiene un encabezado con las columnas mapX, mapY, sourceX y sourceY</translation>
    </message>
    <message>
        <source>holds no points</source>
        <translation>no contiene puntos</translation>
    </message>
    <message>
        <source>more than %1 lines are no points</source>
        <translation>más de %1 líneas no son puntos</translation>
    </message>
    <message>
        <source>its points do not lie in these two maps, neither as metres nor as pixels; were they made with them?</source>
        <translation>sus puntos no están en estos dos mapas, ni como metros ni como píxeles; ¿se hicieron con ellos?</translation>
    </message>
    <message>
        <source>is not a project of CAD2SLAM</source>
        <translation>no es un proyecto de CAD2SLAM</translation>
    </message>
    <message>
        <source>was written by a newer program (format %1); this one reads format %2</source>
        <translation>lo escribió un programa más nuevo (formato %1); este lee el formato %2</translation>
    </message>
    <message>
        <source>is too large for a project</source>
        <translation>es demasiado grande para un proyecto</translation>
    </message>
    <message>
        <source>cannot name the file %1, which is not UTF-8</source>
        <translation>no puede nombrar el archivo %1, cuyo nombre no es UTF-8</translation>
    </message>
    <message>
        <source>is no text: it holds zero bytes</source>
        <translation>no es texto: contiene bytes nulos</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>no es JSON válido</translation>
    </message>
    <message>
        <source>is nested too deeply</source>
        <translation>está anidado demasiado hondo</translation>
    </message>
    <message>
        <source>has the key %1 twice in one object</source>
        <translation>tiene la clave %1 dos veces en un objeto</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>el documento</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>falta %1</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 debe ser un objeto</translation>
    </message>
    <message>
        <source>%1 must be a list</source>
        <translation>%1 debe ser una lista</translation>
    </message>
    <message>
        <source>%1 must be a list of two numbers</source>
        <translation>%1 debe ser una lista de dos números</translation>
    </message>
    <message>
        <source>%1 must be a list of three numbers: x, y, yaw</source>
        <translation>%1 debe ser una lista de tres números: x, y, giro</translation>
    </message>
    <message>
        <source>%1 must be a text</source>
        <translation>%1 debe ser un texto</translation>
    </message>
    <message>
        <source>%1 must be true or false</source>
        <translation>%1 debe ser true o false</translation>
    </message>
    <message>
        <source>%1 must be a finite number in its range</source>
        <translation>%1 debe ser un número finito dentro de su intervalo</translation>
    </message>
    <message>
        <source>%1 must be a whole number in its range</source>
        <translation>%1 debe ser un número entero dentro de su intervalo</translation>
    </message>
    <message>
        <source>%1 must be 64 hexadecimal digits</source>
        <translation>%1 debe constar de 64 dígitos hexadecimales</translation>
    </message>
    <message>
        <source>%1 must not be above occupied_thresh</source>
        <translation>%1 no debe superar occupied_thresh</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1 no debe estar vacío</translation>
    </message>
    <message>
        <source>%1 is not one of the words known here</source>
        <translation>%1 no es ninguna de las palabras conocidas aquí</translation>
    </message>
    <message>
        <source>%1 is no file name</source>
        <translation>%1 no es un nombre de archivo</translation>
    </message>
    <message>
        <source>%1 is the name of another map, too: %2</source>
        <translation>%1 es también el nombre de otro mapa: %2</translation>
    </message>
    <message>
        <source>%1 stands twice</source>
        <translation>%1 está dos veces</translation>
    </message>
    <message>
        <source>%1 stands twice: %2</source>
        <translation>%1 está dos veces: %2</translation>
    </message>
    <message>
        <source>is not a projector file of CAD2SLAM</source>
        <translation>no es un archivo de proyector de CAD2SLAM</translation>
    </message>
    <message>
        <source>has no known version</source>
        <translation>no tiene una versión conocida</translation>
    </message>
    <message>
        <source>has format version %1; this program reads %2.x</source>
        <translation>tiene la versión de formato %1; este programa lee %2.x</translation>
    </message>
    <message>
        <source>needs more memory than there is</source>
        <translation>necesita más memoria de la que hay</translation>
    </message>
    <message>
        <source>is no projector file: it has only %1 bytes</source>
        <translation>no es un archivo de proyector: solo tiene %1 bytes</translation>
    </message>
    <message>
        <source>is no projector file: its header would be too long</source>
        <translation>no es un archivo de proyector: su cabecera sería demasiado larga</translation>
    </message>
    <message>
        <source>is no projector file: zero bytes in its header</source>
        <translation>no es un archivo de proyector: bytes nulos en su cabecera</translation>
    </message>
    <message>
        <source>is cut off inside its header</source>
        <translation>está cortado dentro de su cabecera</translation>
    </message>
    <message>
        <source>is cut off: %1 bytes are missing</source>
        <translation>está cortado: faltan %1 bytes</translation>
    </message>
    <message>
        <source>has %1 bytes too many</source>
        <translation>tiene %1 bytes de más</translation>
    </message>
    <message>
        <source>is damaged: its header was changed</source>
        <translation>está dañado: su cabecera se cambió</translation>
    </message>
    <message>
        <source>is damaged: its data do not have the SHA-256 they should</source>
        <translation>está dañado: sus datos no tienen el SHA-256 que deberían</translation>
    </message>
    <message>
        <source>has no data_sha256</source>
        <translation>no tiene data_sha256</translation>
    </message>
    <message>
        <source>has no array %1</source>
        <translation>no tiene la lista %1</translation>
    </message>
    <message>
        <source>has an array %1 that is not %2 in %3 columns</source>
        <translation>tiene una lista %1 que no es %2 en %3 columnas</translation>
    </message>
    <message>
        <source>has node arrays of different lengths</source>
        <translation>tiene listas de nodos de distinta longitud</translation>
    </message>
    <message>
        <source>has an edge to a node that does not exist</source>
        <translation>tiene una arista hacia un nodo que no existe</translation>
    </message>
    <message>
        <source>has an anchor that is not finite</source>
        <translation>tiene un ancla que no es finita</translation>
    </message>
    <message>
        <source>has a check pose that is not finite</source>
        <translation>tiene una pose de control que no es finita</translation>
    </message>
    <message>
        <source>does not reproduce its own check pose %1</source>
        <translation>no reproduce su propia pose de control %1</translation>
    </message>
    <message>
        <source>has an array of unknown type or impossible size: %1</source>
        <translation>tiene una lista de tipo desconocido o tamaño imposible: %1</translation>
    </message>
    <message>
        <source>has an array whose range does not fit its shape: %1</source>
        <translation>tiene una lista cuyo intervalo no corresponde a su forma: %1</translation>
    </message>
    <message>
        <source>has arrays that overlap or leave a gap at byte %1</source>
        <translation>tiene listas que se solapan o dejan un hueco en el byte %1</translation>
    </message>
    <message>
        <source>has a header that %1</source>
        <translation>tiene una cabecera ilegible: %1</translation>
    </message>
    <message>
        <source>is no JSON object</source>
        <translation>no es un objeto JSON</translation>
    </message>
    <message>
        <source>is not valid JSON at byte %1</source>
        <translation>no es JSON válido en el byte %1</translation>
    </message>
    <message>
        <source>has the name %1 twice</source>
        <translation>tiene el nombre %1 dos veces</translation>
    </message>
    <message>
        <source>has the key %1 twice in %2</source>
        <translation>tiene la clave %1 dos veces en %2</translation>
    </message>
    <message>
        <source>has the unknown key %1 in %2</source>
        <translation>tiene la clave desconocida %1 en %2</translation>
    </message>
    <message>
        <source>has too many arrays</source>
        <translation>tiene demasiadas listas</translation>
    </message>
    <message>
        <source>has too long a list in %1</source>
        <translation>tiene una lista demasiado larga en %1</translation>
    </message>
    <message>
        <source>does not say dtype, shape and data_offsets of %1</source>
        <translation>no indica dtype, shape y data_offsets de %1</translation>
    </message>
    <message>
        <source>has data_offsets that are not two numbers in %1</source>
        <translation>tiene data_offsets que no son dos números en %1</translation>
    </message>
    <message>
        <source>has %1 where it should not, in %2</source>
        <translation>tiene %1 donde no debería, en %2</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>a truth value</source>
        <translation>un valor lógico</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a negative number</source>
        <translation>un número negativo</translation>
    </message>
    <message>
        <source>a number with a fraction</source>
        <translation>un número con decimales</translation>
    </message>
    <message>
        <source>binary data</source>
        <translation>datos binarios</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objeto</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>the metadata %1 is missing</source>
        <translation>falta %1 en los metadatos</translation>
    </message>
    <message>
        <source>the metadata %1 is %2, not a finite number</source>
        <translation>el valor %1 de los metadatos es %2, no un número finito</translation>
    </message>
    <message>
        <source>the metadata %1 is %2, not a whole number from 0 on</source>
        <translation>el valor %1 de los metadatos es %2, no un número entero desde 0</translation>
    </message>
    <message>
        <source>the metadata %1 is %2, which is not known</source>
        <translation>el valor %1 de los metadatos es %2, que no se conoce</translation>
    </message>
    <message>
        <source>the metadata %1 is not 64 hexadecimal digits</source>
        <translation>el valor %1 de los metadatos no son 64 dígitos hexadecimales</translation>
    </message>
    <message>
        <source>There is not enough memory for this; use larger cells or a smaller image</source>
        <translation>No hay memoria suficiente para esto; use celdas mayores o una imagen más pequeña</translation>
    </message>
    <message>
        <source>Something went wrong inside the program</source>
        <translation>Algo falló dentro del programa</translation>
    </message>
    <message>
        <source>Something went wrong inside the program: %1</source>
        <translation>Algo falló dentro del programa: %1</translation>
    </message>
    <message>
        <source>not loaded</source>
        <translation>sin cargar</translation>
    </message>
    <message>
        <source>there is nothing to lay over the map</source>
        <translation>no hay nada que superponer al mapa</translation>
    </message>
    <message>
        <source>There is no up-to-date alignment to export</source>
        <translation>No hay una alineación al día que exportar</translation>
    </message>
    <message>
        <source>The export was cancelled, nothing was written</source>
        <translation>La exportación se canceló, no se escribió nada</translation>
    </message>
    <message>
        <source>The file reads back with other values</source>
        <translation>El archivo se relee con otros valores</translation>
    </message>
    <message>
        <source>The file reads back with other values: do not use it</source>
        <translation>El archivo se relee con otros valores: no lo use</translation>
    </message>
    <message>
        <source>Going there and back through the file does not return to the start</source>
        <translation>Ir y volver por el archivo no regresa al punto de partida</translation>
    </message>
    <message>
        <source>1 part of the free space (1 node) is not connected to any anchor and only follows the global fit.</source>
        <translation>1 parte del espacio libre (1 nodo) no está conectada con ninguna ancla y solo sigue la alineación global.</translation>
    </message>
    <message>
        <source>1 part of the free space (%1 nodes) is not connected to any anchor and only follows the global fit.</source>
        <translation>1 parte del espacio libre (%1 nodos) no está conectada con ninguna ancla y solo sigue la alineación global.</translation>
    </message>
    <message>
        <source>%1 parts of the free space (%2 nodes) are not connected to any anchor and only follow the global fit.</source>
        <translation>%1 partes del espacio libre (%2 nodos) no están conectadas con ninguna ancla y solo siguen la alineación global.</translation>
    </message>
</context>
<context>
    <name>Hints</name>
    <message>
        <source>Choose the blueprint: drop its YAML or image into the left view</source>
        <translation>Elija el plano: arrastre su YAML o imagen a la vista izquierda</translation>
    </message>
    <message>
        <source>Choose the SLAM map: drop its YAML or image into the right view</source>
        <translation>Elija el mapa SLAM: arrastre su YAML o imagen a la vista derecha</translation>
    </message>
    <message>
        <source>Loading the images...</source>
        <translation>Cargando las imágenes...</translation>
    </message>
    <message>
        <source>An image is missing; see the message above</source>
        <translation>Falta una imagen; vea el mensaje de arriba</translation>
    </message>
    <message>
        <source>Anchors are locked for looking only (K unlocks)</source>
        <translation>Las anclas están bloqueadas, solo para mirar (K desbloquea)</translation>
    </message>
    <message>
        <source>Now click the same place in the SLAM map (Esc cancels)</source>
        <translation>Ahora haga clic en el mismo lugar del mapa SLAM (Esc cancela)</translation>
    </message>
    <message>
        <source>Now click the same place in the blueprint (Esc cancels)</source>
        <translation>Ahora haga clic en el mismo lugar del plano (Esc cancela)</translation>
    </message>
    <message>
        <source>Click a corner or pillar in either view</source>
        <translation>Haga clic en una esquina o un pilar en cualquiera de las vistas</translation>
    </message>
    <message>
        <source>Rotation unknown: add another anchor far away from the first</source>
        <translation>Giro desconocido: añada otra ancla lejos de la primera</translation>
    </message>
    <message>
        <source>Rough alignment; add more anchors, best in rooms that have none yet</source>
        <translation>Alineación aproximada; añada más anclas, mejor en salas que aún no tengan</translation>
    </message>
    <message>
        <source>Add a fourth anchor, then each one is checked by the others</source>
        <translation>Añada una cuarta ancla; después cada una se comprueba con las demás</translation>
    </message>
    <message>
        <source>Add anchors where the overlay is off; look at the worst one with N</source>
        <translation>Añada anclas donde la superposición no encaje; N muestra la peor</translation>
    </message>
    <message>
        <source>no alignment</source>
        <translation>sin alineación</translation>
    </message>
    <message>
        <source>Both images are needed</source>
        <translation>Se necesitan ambas imágenes</translation>
    </message>
    <message>
        <source>no anchors</source>
        <translation>sin anclas</translation>
    </message>
    <message>
        <source>Nothing to solve yet</source>
        <translation>Aún no hay nada que resolver</translation>
    </message>
    <message>
        <source>solving...</source>
        <translation>resolviendo...</translation>
    </message>
    <message>
        <source>Click to stop (Ctrl+.)</source>
        <translation>Clic para detener (Ctrl+.)</translation>
    </message>
    <message>
        <source>up to date, %1 s</source>
        <translation>al día, %1 s</translation>
    </message>
    <message>
        <source>%1 nodes, %2 iterations</source>
        <translation>%1 nodos, %2 iteraciones</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>falló</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>Click to solve again (F5)</source>
        <translation>Clic para resolver otra vez (F5)</translation>
    </message>
    <message>
        <source>Click the same place in the SLAM map, or press Enter to take the predicted place (Esc cancels)</source>
        <translation>Haga clic en el mismo lugar del mapa SLAM o pulse Intro para tomar el lugar previsto (Esc cancela)</translation>
    </message>
    <message>
        <source>Click the same place in the blueprint, or press Enter to take the predicted place (Esc cancels)</source>
        <translation>Haga clic en el mismo lugar del plano o pulse Intro para tomar el lugar previsto (Esc cancela)</translation>
    </message>
    <message>
        <source>solving the others...</source>
        <translation>resolviendo los demás...</translation>
    </message>
    <message>
        <source>The other SLAM maps are solved for the preview; click to stop (Ctrl+.)</source>
        <translation>Los demás mapas SLAM se resuelven para la vista previa; clic para detener (Ctrl+.)</translation>
    </message>
    <message>
        <source>The alignment could not be solved; see the message above</source>
        <translation>No se pudo resolver la alineación; vea el mensaje de arriba</translation>
    </message>
    <message>
        <source>The alignment was stopped: F5 solves it again</source>
        <translation>La alineación se detuvo: F5 la resuelve de nuevo</translation>
    </message>
    <message>
        <source>Solving the alignment...</source>
        <translation>Resolviendo la alineación...</translation>
    </message>
    <message>
        <source>No anchor is used: switch some on in the table, or place new ones</source>
        <translation>No se usa ninguna ancla: active algunas en la tabla o coloque otras</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>falló: %1</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>&amp;Mapas</translation>
    </message>
    <message>
        <source>SLAM map being &amp;edited</source>
        <translation>Mapa SLAM en &amp;edición</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>P&amp;anels</source>
        <translation>Pa&amp;neles</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Main tool bar</source>
        <translation>Barra de herramientas principal</translation>
    </message>
</context>
<context>
    <name>ProgramActions</name>
    <message>
        <source>The language changes at the next start of the program</source>
        <translation>El idioma cambia la próxima vez que se inicie el programa</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Guardar informe</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>About CAD2SLAM</source>
        <translation>Acerca de CAD2SLAM</translation>
    </message>
    <message>
        <source>&lt;h3&gt;CAD2SLAM %1&lt;/h3&gt;&lt;p&gt;Projects poses between building blueprints and robot SLAM maps.&lt;/p&gt;&lt;p&gt;Apache License 2.0. Uses Qt, Ceres, SuiteSparse, OpenCV and Eigen.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;CAD2SLAM %1&lt;/h3&gt;&lt;p&gt;Proyecta poses entre planos de edificios y mapas SLAM de robots.&lt;/p&gt;&lt;p&gt;Licencia Apache 2.0. Usa Qt, Ceres, SuiteSparse, OpenCV y Eigen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>SLAM map</source>
        <translation>Mapa SLAM</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Informe escrito en %1</translation>
    </message>
    <message>
        <source>Show poses from file</source>
        <translation>Mostrar poses de un archivo</translation>
    </message>
    <message>
        <source>Poses (*.csv *.txt);;All files (*)</source>
        <translation>Poses (*.csv *.txt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Show poses</source>
        <translation>Mostrar poses</translation>
    </message>
    <message>
        <source>The poses are in the frame of the:</source>
        <translation>Las poses están en el marco de:</translation>
    </message>
    <message>
        <source>%1 poses shown</source>
        <translation>%1 poses mostradas</translation>
    </message>
    <message>
        <source>No line of %1 starts with two numbers x, y</source>
        <translation>Ninguna línea de %1 empieza con dos números x, y</translation>
    </message>
    <message>
        <source>%1 lines without two numbers left out</source>
        <translation>%1 líneas sin dos números omitidas</translation>
    </message>
    <message>
        <source>There are more: only the first are shown</source>
        <translation>Hay más: solo se muestran las primeras</translation>
    </message>
    <message>
        <source>the clipboard</source>
        <translation>el portapapeles</translation>
    </message>
    <message>
        <source>Both maps: blueprint magenta, SLAM map green, dark where they agree</source>
        <translation>Ambos mapas: plano magenta, mapa SLAM verde, oscuro donde coinciden</translation>
    </message>
    <message>
        <source>Test pose in the blueprint</source>
        <translation>Pose de prueba en el plano</translation>
    </message>
    <message>
        <source>Test pose in the SLAM map</source>
        <translation>Pose de prueba en el mapa SLAM</translation>
    </message>
    <message>
        <source>&amp;x (m):</source>
        <translation>&amp;x (m):</translation>
    </message>
    <message>
        <source>&amp;y (m):</source>
        <translation>&amp;y (m):</translation>
    </message>
    <message>
        <source>&amp;Heading (degrees):</source>
        <translation>&amp;Orientación (grados):</translation>
    </message>
    <message>
        <source>A pose of the SLAM map can be shown once there is an alignment</source>
        <translation>Una pose del mapa SLAM se puede mostrar cuando haya una alineación</translation>
    </message>
    <message>
        <source>A report is about a blueprint and a SLAM map: load both first</source>
        <translation>Un informe trata de un plano y un mapa SLAM: cargue primero ambos</translation>
    </message>
</context>
<context>
    <name>Limits</name>
    <message>
        <source>Judged by the error without it, below %1 anchors by the residual; the larger limit counts:</source>
        <translation>Se juzga por el error sin ella, con menos de %1 anclas por el residuo; cuenta el límite mayor:</translation>
    </message>
    <message>
        <source>● OK up to %1 or %2 pixels of the SLAM map</source>
        <translation>● OK hasta %1 o %2 píxeles del mapa SLAM</translation>
    </message>
    <message>
        <source>◆ Have a look up to %1 or %2 pixels</source>
        <translation>◆ Revisar hasta %1 o %2 píxeles</translation>
    </message>
    <message>
        <source>■ Bad beyond that, if it is also more than %1 times the median or the residual is not OK</source>
        <translation>■ Mala más allá, si además supera %1 veces la mediana o el residuo no es OK</translation>
    </message>
    <message>
        <source>■ From %1 anchors on also bad: not OK and more than %2 standard deviations above the mean</source>
        <translation>■ Desde %1 anclas también mala: no OK y más de %2 desviaciones típicas sobre la media</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>look</source>
        <translation>revisar</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mala</translation>
    </message>
    <message>
        <source>off (check)</source>
        <translation>apagada (control)</translation>
    </message>
    <message>
        <source>%1 m/px</source>
        <translation>%1 m/px</translation>
    </message>
    <message>
        <source>Project not saved</source>
        <translation>Proyecto sin guardar</translation>
    </message>
    <message>
        <source>CAD2SLAM %1, %2</source>
        <translation>CAD2SLAM %1, %2</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Anchors used</source>
        <translation>Anclas usadas</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>RMS of the residuals</source>
        <translation>Media cuadrática de los residuos</translation>
    </message>
    <message>
        <source>Largest residual</source>
        <translation>Residuo mayor</translation>
    </message>
    <message>
        <source>Median error without the anchor itself</source>
        <translation>Mediana del error sin la propia ancla</translation>
    </message>
    <message>
        <source>Turn and scale of the SLAM map</source>
        <translation>Giro y escala del mapa SLAM</translation>
    </message>
    <message>
        <source>%1°, %2</source>
        <translation>%1°, %2</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>%1 nodes, cells of %2 m, folded tiles: %3</source>
        <translation>%1 nodos, celdas de %2 m, teselas plegadas: %3</translation>
    </message>
    <message>
        <source>To look at</source>
        <translation>Por revisar</translation>
    </message>
    <message>
        <source>Anchors</source>
        <translation>Anclas</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Blueprint x, y (m)</source>
        <translation>Plano x, y (m)</translation>
    </message>
    <message>
        <source>SLAM map x, y (m)</source>
        <translation>Mapa SLAM x, y (m)</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuo</translation>
    </message>
    <message>
        <source>Without it</source>
        <translation>Sin ella</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolución</translation>
    </message>
    <message>
        <source>SHA-256 (first 16)</source>
        <translation>SHA-256 (primeros 16)</translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>SLAM map</source>
        <translation>Mapa SLAM</translation>
    </message>
    <message>
        <source>CAD2SLAM report</source>
        <translation>Informe de CAD2SLAM</translation>
    </message>
    <message>
        <source>The project has changes that are not saved in its file.</source>
        <translation>El proyecto tiene cambios que no están guardados en su archivo.</translation>
    </message>
    <message>
        <source>The figures below are those of an earlier state: the project as it is was not solved.</source>
        <translation>Las cifras de abajo son de un estado anterior: el proyecto actual no se ha resuelto.</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Página %1 de %2</translation>
    </message>
</context>
<context>
    <name>SavePath</name>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
</context>
<context>
    <name>StatusStrip</name>
    <message>
        <source>What to do next</source>
        <translation>Qué hacer a continuación</translation>
    </message>
</context>
<context>
    <name>cad2slam::Actions</name>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Nuevo proyecto</translation>
    </message>
    <message>
        <source>Start with an empty project</source>
        <translation>Empezar con un proyecto vacío</translation>
    </message>
    <message>
        <source>&amp;Open project...</source>
        <translation>&amp;Abrir proyecto...</translation>
    </message>
    <message>
        <source>Open a project file</source>
        <translation>Abrir un archivo de proyecto</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>&amp;Guardar proyecto</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Guardar el proyecto</translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation>Guardar proyecto &amp;como...</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Guardar el proyecto con otro nombre</translation>
    </message>
    <message>
        <source>Choose &amp;blueprint...</source>
        <translation>Elegir &amp;plano...</translation>
    </message>
    <message>
        <source>Choose the plan of the building: a map YAML or an image</source>
        <translation>Elegir el plano del edificio: YAML de mapa o imagen</translation>
    </message>
    <message>
        <source>Add SLAM &amp;map...</source>
        <translation>Añadir &amp;mapa SLAM...</translation>
    </message>
    <message>
        <source>Add a robot&apos;s map: a map YAML or an image</source>
        <translation>Añadir el mapa de un robot: YAML de mapa o imagen</translation>
    </message>
    <message>
        <source>&amp;Import anchors...</source>
        <translation>&amp;Importar anclas...</translation>
    </message>
    <message>
        <source>Read anchors from a CSV file</source>
        <translation>Leer anclas de un archivo CSV</translation>
    </message>
    <message>
        <source>Export an&amp;chors...</source>
        <translation>E&amp;xportar anclas...</translation>
    </message>
    <message>
        <source>Write the anchors to a CSV file</source>
        <translation>Escribir las anclas en un archivo CSV</translation>
    </message>
    <message>
        <source>&amp;Export projector...</source>
        <translation>Exportar pro&amp;yector...</translation>
    </message>
    <message>
        <source>Write the file that robots use</source>
        <translation>Escribir el archivo que usan los robots</translation>
    </message>
    <message>
        <source>Inspect a pro&amp;jector...</source>
        <translation>Inspeccionar un proyec&amp;tor...</translation>
    </message>
    <message>
        <source>Tell what a projector file was made from</source>
        <translation>Decir de qué se hizo un archivo de proyector</translation>
    </message>
    <message>
        <source>Save &amp;report...</source>
        <translation>Guardar &amp;informe...</translation>
    </message>
    <message>
        <source>Write a report with pictures as PDF</source>
        <translation>Escribir un informe con imágenes en PDF</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>&amp;Ajustes...</translation>
    </message>
    <message>
        <source>Solver, limits and appearance</source>
        <translation>Resolución, límites y apariencia</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Cerrar el programa</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Take back the last step</source>
        <translation>Deshacer el último paso</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Do the step again</source>
        <translation>Hacer el paso otra vez</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Borrar</translation>
    </message>
    <message>
        <source>Delete the selected anchors</source>
        <translation>Borrar las anclas seleccionadas</translation>
    </message>
    <message>
        <source>&amp;Use / do not use</source>
        <translation>&amp;Usar / no usar</translation>
    </message>
    <message>
        <source>Switch the selected anchors on or off</source>
        <translation>Encender o apagar las anclas seleccionadas</translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation>Cambiar &amp;nombre...</translation>
    </message>
    <message>
        <source>Give the selected anchor a name</source>
        <translation>Dar un nombre al ancla seleccionada</translation>
    </message>
    <message>
        <source>&amp;Type coordinates...</source>
        <translation>&amp;Escribir coordenadas...</translation>
    </message>
    <message>
        <source>Add an anchor, or change the selected one, by numbers</source>
        <translation>Añadir un ancla, o cambiar la seleccionada, con números</translation>
    </message>
    <message>
        <source>S&amp;wap counterparts</source>
        <translation>&amp;Intercambiar contrapartes</translation>
    </message>
    <message>
        <source>Exchange the SLAM points of the two selected anchors</source>
        <translation>Intercambiar los puntos SLAM de las dos anclas seleccionadas</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Seleccionar &amp;todo</translation>
    </message>
    <message>
        <source>Select all anchors</source>
        <translation>Seleccionar todas las anclas</translation>
    </message>
    <message>
        <source>Disable &amp;worst</source>
        <translation>Apagar la &amp;peor</translation>
    </message>
    <message>
        <source>Do not use the anchor with the largest error</source>
        <translation>No usar el ancla con el error mayor</translation>
    </message>
    <message>
        <source>&amp;Lock anchors</source>
        <translation>&amp;Bloquear anclas</translation>
    </message>
    <message>
        <source>Look only: no anchor can be changed</source>
        <translation>Solo mirar: ningún ancla se puede cambiar</translation>
    </message>
    <message>
        <source>&amp;Snap to corners</source>
        <translation>A&amp;justar a esquinas</translation>
    </message>
    <message>
        <source>Clicks go to the corner that is shown; hold Alt to suspend</source>
        <translation>Los clics van a la esquina mostrada; mantenga Alt para suspender</translation>
    </message>
    <message>
        <source>&amp;Rescale blueprint...</source>
        <translation>&amp;Reescalar plano...</translation>
    </message>
    <message>
        <source>Correct the scale of the blueprint; anchors keep their places</source>
        <translation>Corregir la escala del plano; las anclas conservan su lugar</translation>
    </message>
    <message>
        <source>&amp;Mirror blueprint</source>
        <translation>&amp;Reflejar plano</translation>
    </message>
    <message>
        <source>Mirror the blueprint left to right; anchors keep their places</source>
        <translation>Reflejar el plano de izquierda a derecha; las anclas conservan su lugar</translation>
    </message>
    <message>
        <source>Rename SLAM map...</source>
        <translation>Renombrar mapa SLAM...</translation>
    </message>
    <message>
        <source>Give the SLAM map another name</source>
        <translation>Dar otro nombre al mapa SLAM</translation>
    </message>
    <message>
        <source>Remove SLAM map</source>
        <translation>Quitar mapa SLAM</translation>
    </message>
    <message>
        <source>Take this SLAM map and its anchors out of the project</source>
        <translation>Quitar del proyecto este mapa SLAM y sus anclas</translation>
    </message>
    <message>
        <source>&amp;Copy anchors from...</source>
        <translation>&amp;Copiar anclas de...</translation>
    </message>
    <message>
        <source>Take over the blueprint points of another SLAM map&apos;s anchors</source>
        <translation>Tomar los puntos del plano de las anclas de otro mapa SLAM</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Encajar</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>Mostrar toda la imagen</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>One image pixel for each screen pixel</source>
        <translation>Un píxel de imagen por píxel de pantalla</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Acercar</translation>
    </message>
    <message>
        <source>Show less, larger</source>
        <translation>Mostrar menos, más grande</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>A&amp;lejar</translation>
    </message>
    <message>
        <source>Show more, smaller</source>
        <translation>Mostrar más, más pequeño</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Girar a la i&amp;zquierda</translation>
    </message>
    <message>
        <source>Turn this view by 15 degrees to the left</source>
        <translation>Girar esta vista 15 grados a la izquierda</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>Girar a la &amp;derecha</translation>
    </message>
    <message>
        <source>Turn this view by 15 degrees to the right</source>
        <translation>Girar esta vista 15 grados a la derecha</translation>
    </message>
    <message>
        <source>Turn &amp;back</source>
        <translation>&amp;Enderezar</translation>
    </message>
    <message>
        <source>Show this view upright again</source>
        <translation>Mostrar esta vista derecha otra vez</translation>
    </message>
    <message>
        <source>&amp;Centre on anchor</source>
        <translation>&amp;Centrar en el ancla</translation>
    </message>
    <message>
        <source>Show the selected anchor in the middle of both views</source>
        <translation>Mostrar el ancla seleccionada en el centro de ambas vistas</translation>
    </message>
    <message>
        <source>&amp;Next by error</source>
        <translation>&amp;Siguiente por error</translation>
    </message>
    <message>
        <source>Go to the anchor with the next smaller error</source>
        <translation>Ir al ancla con el siguiente error menor</translation>
    </message>
    <message>
        <source>&amp;Previous by error</source>
        <translation>&amp;Anterior por error</translation>
    </message>
    <message>
        <source>Go to the anchor with the next larger error</source>
        <translation>Ir al ancla con el siguiente error mayor</translation>
    </message>
    <message>
        <source>Lin&amp;k views</source>
        <translation>&amp;Enlazar vistas</translation>
    </message>
    <message>
        <source>Both views show the same place, turned the same way</source>
        <translation>Ambas vistas muestran el mismo lugar, giradas igual</translation>
    </message>
    <message>
        <source>Other view goes &amp;here</source>
        <translation>La otra vista viene a&amp;quí</translation>
    </message>
    <message>
        <source>The other view shows what this one shows</source>
        <translation>La otra vista muestra lo que muestra esta</translation>
    </message>
    <message>
        <source>Go where the &amp;other is</source>
        <translation>Ir donde está la &amp;otra</translation>
    </message>
    <message>
        <source>This view shows what the other one shows</source>
        <translation>Esta vista muestra lo que muestra la otra</translation>
    </message>
    <message>
        <source>&amp;Loupe</source>
        <translation>&amp;Lupa</translation>
    </message>
    <message>
        <source>Magnify what is under the cursor; hold Z for a moment</source>
        <translation>Ampliar lo que está bajo el cursor; mantenga Z por un momento</translation>
    </message>
    <message>
        <source>&amp;Markers</source>
        <translation>&amp;Marcas</translation>
    </message>
    <message>
        <source>Show or hide the anchors</source>
        <translation>Mostrar u ocultar las anclas</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Etiquetas</translation>
    </message>
    <message>
        <source>Show or hide numbers and names</source>
        <translation>Mostrar u ocultar números y nombres</translation>
    </message>
    <message>
        <source>M&amp;esh</source>
        <translation>Ma&amp;lla</translation>
    </message>
    <message>
        <source>Show the mesh; colours tell how much it is stretched</source>
        <translation>Mostrar la malla; los colores dicen cuánto se estira</translation>
    </message>
    <message>
        <source>Resi&amp;duals</source>
        <translation>Resi&amp;duos</translation>
    </message>
    <message>
        <source>Show what each anchor misses</source>
        <translation>Mostrar lo que le falta a cada ancla</translation>
    </message>
    <message>
        <source>Residuals &amp;x10</source>
        <translation>Residuos &amp;x10</translation>
    </message>
    <message>
        <source>Draw residuals ten times as long</source>
        <translation>Dibujar los residuos diez veces más largos</translation>
    </message>
    <message>
        <source>Test &amp;pose</source>
        <translation>&amp;Pose de prueba</translation>
    </message>
    <message>
        <source>Drag a robot in either view and see it in the other</source>
        <translation>Arrastrar un robot en una vista y verlo en la otra</translation>
    </message>
    <message>
        <source>Show poses &amp;from file...</source>
        <translation>Mostrar poses de un &amp;archivo...</translation>
    </message>
    <message>
        <source>Show a CSV of poses in both views</source>
        <translation>Mostrar un CSV de poses en ambas vistas</translation>
    </message>
    <message>
        <source>Plan a pa&amp;th</source>
        <translation>Planear un &amp;camino</translation>
    </message>
    <message>
        <source>Show the way from the first to the second test pose in both views</source>
        <translation>Mostrar el camino de la primera a la segunda pose de prueba en ambas vistas</translation>
    </message>
    <message>
        <source>Next part of the window</source>
        <translation>Siguiente parte de la ventana</translation>
    </message>
    <message>
        <source>Go on with the keyboard in the next part of the window</source>
        <translation>Seguir con el teclado en la siguiente parte de la ventana</translation>
    </message>
    <message>
        <source>&amp;Solve again</source>
        <translation>&amp;Resolver otra vez</translation>
    </message>
    <message>
        <source>Compute the alignment again</source>
        <translation>Calcular la alineación otra vez</translation>
    </message>
    <message>
        <source>St&amp;op solving</source>
        <translation>&amp;Detener la resolución</translation>
    </message>
    <message>
        <source>Stop the computation; the last result stays</source>
        <translation>Detener el cálculo; queda el último resultado</translation>
    </message>
    <message>
        <source>Next preview &amp;mode</source>
        <translation>Siguiente &amp;modo de vista previa</translation>
    </message>
    <message>
        <source>Overlay, two inks, swipe, blink, lens, ...</source>
        <translation>Superposición, dos tintas, cortina, parpadeo, lente, ...</translation>
    </message>
    <message>
        <source>&amp;Less overlay</source>
        <translation>&amp;Menos superposición</translation>
    </message>
    <message>
        <source>Make the overlay more transparent</source>
        <translation>Hacer la superposición más transparente</translation>
    </message>
    <message>
        <source>M&amp;ore overlay</source>
        <translation>Más &amp;superposición</translation>
    </message>
    <message>
        <source>Make the overlay more opaque</source>
        <translation>Hacer la superposición más opaca</translation>
    </message>
    <message>
        <source>Swap preview &amp;direction</source>
        <translation>Cambiar la &amp;dirección de la vista previa</translation>
    </message>
    <message>
        <source>Blueprint over SLAM map, or SLAM map over blueprint</source>
        <translation>Plano sobre mapa SLAM, o mapa SLAM sobre plano</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Alto contraste</translation>
    </message>
    <message>
        <source>For bright sunlight</source>
        <translation>Para pleno sol</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Teclas</translation>
    </message>
    <message>
        <source>All keys on one page</source>
        <translation>Todas las teclas en una página</translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation>&amp;Recorrido guiado</translation>
    </message>
    <message>
        <source>A few steps on a sample building</source>
        <translation>Unos pasos en un edificio de ejemplo</translation>
    </message>
    <message>
        <source>&amp;About CAD2SLAM</source>
        <translation>&amp;Acerca de CAD2SLAM</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versión y licencia</translation>
    </message>
    <message>
        <source>Show poses from the &amp;clipboard...</source>
        <translation>Mostrar poses del &amp;portapapeles...</translation>
    </message>
    <message>
        <source>Show copied lines x, y, heading in both views</source>
        <translation>Mostrar en ambas vistas las líneas copiadas x, y, orientación</translation>
    </message>
    <message>
        <source>&amp;Remove shown poses</source>
        <translation>&amp;Quitar las poses mostradas</translation>
    </message>
    <message>
        <source>Take the poses from file or clipboard away again</source>
        <translation>Retirar las poses del archivo o del portapapeles</translation>
    </message>
    <message>
        <source>Place a &amp;point in the middle</source>
        <translation>Colocar un &amp;punto en el centro</translation>
    </message>
    <message>
        <source>As a click in the middle of the view, where the arrow keys have moved it</source>
        <translation>Como un clic en el centro de la vista, adonde la han llevado las flechas</translation>
    </message>
    <message>
        <source>Test pose by &amp;numbers...</source>
        <translation>Pose de prueba con &amp;números...</translation>
    </message>
    <message>
        <source>Put the robot to x, y and heading in the frame of this view</source>
        <translation>Poner el robot en x, y y orientación en las coordenadas de esta vista</translation>
    </message>
</context>
<context>
    <name>cad2slam::AnchorEditing</name>
    <message>
        <source>A pixel can be from %1 to %2 metres wide</source>
        <translation>Un píxel puede medir de %1 a %2 metros de ancho</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Anchor %1 deleted</source>
        <translation>Ancla %1 borrada</translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) deleted</source>
        <translation>
            <numerusform>%n ancla borrada</numerusform>
            <numerusform>%n anclas borradas</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Anchor %1 is no longer used; it was off by %2</source>
        <translation>El ancla %1 ya no se usa; erraba por %2</translation>
    </message>
    <message>
        <source>Rescale blueprint</source>
        <translation>Reescalar plano</translation>
    </message>
    <message>
        <source>Metres for each pixel of the blueprint:</source>
        <translation>Metros por píxel del plano:</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a length above zero</source>
        <translation>«%1» no es una longitud mayor que cero</translation>
    </message>
    <message>
        <source>Copy anchors</source>
        <translation>Copiar anclas</translation>
    </message>
    <message>
        <source>From SLAM map:</source>
        <translation>Del mapa SLAM:</translation>
    </message>
    <message>
        <source>copied from %1; move its SLAM point to the right place, then switch it on</source>
        <translation>copiada de %1; mueva su punto SLAM al lugar correcto y luego enciéndala</translation>
    </message>
    <message>
        <source>copy anchors from %1</source>
        <translation>copiar anclas de %1</translation>
    </message>
    <message>
        <source>Anchors are locked for looking only</source>
        <translation>Las anclas están bloqueadas: solo para mirar</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Desbloquear</translation>
    </message>
    <message>
        <source>Coordinates of anchor %1</source>
        <translation>Coordenadas del ancla %1</translation>
    </message>
    <message>
        <source>New anchor %1</source>
        <translation>Nueva ancla %1</translation>
    </message>
    <message>
        <source>Blueprint &amp;x (m):</source>
        <translation>Plano &amp;x (m):</translation>
    </message>
    <message>
        <source>Blueprint &amp;y (m):</source>
        <translation>Plano &amp;y (m):</translation>
    </message>
    <message>
        <source>&amp;SLAM map x (m):</source>
        <translation>Mapa &amp;SLAM x (m):</translation>
    </message>
    <message>
        <source>SLAM &amp;map y (m):</source>
        <translation>&amp;Mapa SLAM y (m):</translation>
    </message>
</context>
<context>
    <name>cad2slam::AnchorPanel</name>
    <message>
        <source>Anchors</source>
        <translation>Anclas</translation>
    </message>
    <message>
        <source>No anchors yet. Click a corner or pillar in either view, then the same place in the other.</source>
        <translation>Aún no hay anclas. Haga clic en una esquina o un pilar en una vista, y luego en el mismo lugar de la otra.</translation>
    </message>
    <message>
        <source>Anchors that take part, of all anchors</source>
        <translation>Anclas que participan, de todas las anclas</translation>
    </message>
    <message>
        <source>Root mean square of the residuals of the anchors used</source>
        <translation>Media cuadrática de los residuos de las anclas usadas</translation>
    </message>
    <message>
        <source>Largest residual of the anchors used</source>
        <translation>Residuo mayor de las anclas usadas</translation>
    </message>
    <message>
        <source>Middle of what each anchor would be missed by without itself: an honest guess of the error elsewhere</source>
        <translation>Valor central de lo que se erraría cada ancla sin ella misma: una estimación honesta del error en otros lugares</translation>
    </message>
    <message>
        <source>Used %1 of %2</source>
        <translation>Usadas %1 de %2</translation>
    </message>
    <message>
        <source>RMS %1</source>
        <translation>RMS %1</translation>
    </message>
    <message>
        <source>Largest %1</source>
        <translation>Mayor %1</translation>
    </message>
    <message>
        <source>Without-it median %1</source>
        <translation>Mediana sin ella %1</translation>
    </message>
</context>
<context>
    <name>cad2slam::AnchorTableModel</name>
    <message>
        <source>○ Off; the limits are in the settings</source>
        <translation>○ Apagada; los límites están en los ajustes</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>look</source>
        <translation>revisar</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mala</translation>
    </message>
    <message>
        <source>off</source>
        <translation>apagada</translation>
    </message>
    <message>
        <source>The point is on a corner that was found in the image</source>
        <translation>El punto está en una esquina hallada en la imagen</translation>
    </message>
    <message>
        <source>snapped</source>
        <translation>ajustada</translation>
    </message>
    <message>
        <source>Without anchor %1 the alignment would be off by %2 here</source>
        <translation>Sin el ancla %1 la alineación erraría aquí por %2</translation>
    </message>
    <message>
        <source>Not used: the other anchors put this place %1 from where you clicked</source>
        <translation>No se usa: las demás anclas ponen este lugar a %1 de donde hizo clic</translation>
    </message>
    <message>
        <source>The alignment puts this place %1 from where you clicked</source>
        <translation>La alineación pone este lugar a %1 de donde hizo clic</translation>
    </message>
    <message>
        <source>anchor %1, used</source>
        <translation>ancla %1, usada</translation>
    </message>
    <message>
        <source>anchor %1, not used</source>
        <translation>ancla %1, no usada</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Blueprint x (m)</source>
        <translation>Plano x (m)</translation>
    </message>
    <message>
        <source>Blueprint y (m)</source>
        <translation>Plano y (m)</translation>
    </message>
    <message>
        <source>SLAM map x (m)</source>
        <translation>Mapa SLAM x (m)</translation>
    </message>
    <message>
        <source>SLAM map y (m)</source>
        <translation>Mapa SLAM y (m)</translation>
    </message>
    <message>
        <source>Residual (cm)</source>
        <translation>Residuo (cm)</translation>
    </message>
    <message>
        <source>Without it (cm)</source>
        <translation>Sin ella (cm)</translation>
    </message>
    <message>
        <source>Flag</source>
        <translation>Marca</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Whether the anchor takes part; one that does not is kept as a check (X)</source>
        <translation>Si el ancla participa; la que no, queda como control (X)</translation>
    </message>
    <message>
        <source>Distance between where the alignment puts the anchor and where you clicked</source>
        <translation>Distancia entre donde la alineación pone el ancla y donde hizo clic</translation>
    </message>
    <message>
        <source>How far off the alignment would be here without this anchor (from 4 anchors on)</source>
        <translation>Cuánto erraría aquí la alineación sin esta ancla (desde 4 anclas)</translation>
    </message>
    <message>
        <source>In the image at %1 px</source>
        <translation>En la imagen en %1 px</translation>
    </message>
    <message>
        <source>%1 (%2 px)</source>
        <translation>%1 (%2 px)</translation>
    </message>
</context>
<context>
    <name>cad2slam::Autosave</name>
    <message>
        <source>%1 cannot be created, so nothing is autosaved</source>
        <translation>No se puede crear %1, así que no se guarda nada automáticamente</translation>
    </message>
</context>
<context>
    <name>cad2slam::CheatSheet</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas y ratón</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>Place one half of an anchor; the click in the other view completes it</source>
        <translation>Poner una mitad de un ancla; el clic en la otra vista la completa</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Take the predicted place for the other half</source>
        <translation>Tomar el lugar previsto para la otra mitad</translation>
    </message>
    <message>
        <source>Esc, right click</source>
        <translation>Esc, clic derecho</translation>
    </message>
    <message>
        <source>Drop the half that waits; never closes the window</source>
        <translation>Soltar la mitad que espera; nunca cierra la ventana</translation>
    </message>
    <message>
        <source>Drag an anchor</source>
        <translation>Arrastrar un ancla</translation>
    </message>
    <message>
        <source>Move it; Esc while dragging puts it back</source>
        <translation>Moverla; Esc al arrastrar la devuelve</translation>
    </message>
    <message>
        <source>Drag elsewhere, middle button, Space + drag</source>
        <translation>Arrastrar en otro lugar, botón central, Espacio + arrastrar</translation>
    </message>
    <message>
        <source>Move the map</source>
        <translation>Mover el mapa</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation>Ampliar en el cursor</translation>
    </message>
    <message>
        <source>Shift + wheel, drag the compass</source>
        <translation>Mayús + rueda, arrastrar la brújula</translation>
    </message>
    <message>
        <source>Turn the map; a click on the compass turns it back</source>
        <translation>Girar el mapa; un clic en la brújula lo endereza</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>Nudge the selected anchor by 1 pixel; Shift 10, Ctrl 0.1</source>
        <translation>Empujar el ancla seleccionada 1 píxel; Mayús 10, Ctrl 0,1</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Nudge the other half</source>
        <translation>Empujar la otra mitad</translation>
    </message>
    <message>
        <source>Ctrl + click</source>
        <translation>Ctrl + clic</translation>
    </message>
    <message>
        <source>Select several anchors</source>
        <translation>Seleccionar varias anclas</translation>
    </message>
    <message>
        <source>Hold Z</source>
        <translation>Mantener Z</translation>
    </message>
    <message>
        <source>Loupe under the cursor</source>
        <translation>Lupa bajo el cursor</translation>
    </message>
    <message>
        <source>Hold Alt</source>
        <translation>Mantener Alt</translation>
    </message>
    <message>
        <source>Suspend snapping</source>
        <translation>Suspender el ajuste</translation>
    </message>
    <message>
        <source>Hold B</source>
        <translation>Mantener B</translation>
    </message>
    <message>
        <source>Blink the preview</source>
        <translation>Parpadear la vista previa</translation>
    </message>
    <message>
        <source>Space in the table</source>
        <translation>Espacio en la tabla</translation>
    </message>
    <message>
        <source>Use the anchor or not</source>
        <translation>Usar el ancla o no</translation>
    </message>
    <message>
        <source>In the views</source>
        <translation>En las vistas</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
</context>
<context>
    <name>cad2slam::CoordinateDelegate</name>
    <message>
        <source>This is not a number of metres</source>
        <translation>Esto no es un número de metros</translation>
    </message>
</context>
<context>
    <name>cad2slam::DiagnosisMessages</name>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Rescale blueprint</source>
        <translation>Reescalar plano</translation>
    </message>
    <message>
        <source>Disable %1</source>
        <translation>Apagar %1</translation>
    </message>
    <message>
        <source>Anchors %1 and %2 share a blueprint point but are %3 apart on the SLAM map</source>
        <translation>Las anclas %1 y %2 comparten un punto del plano pero distan %3 en el mapa SLAM</translation>
    </message>
    <message>
        <source>Anchors %1 and %2 share a point of the SLAM map but are %3 apart in the blueprint</source>
        <translation>Las anclas %1 y %2 comparten un punto del mapa SLAM pero distan %3 en el plano</translation>
    </message>
    <message>
        <source>The blueprint looks mirrored: mirrored, the anchors would be off by %1 instead of %2</source>
        <translation>El plano parece reflejado: reflejándolo, las anclas errarían %1 en vez de %2</translation>
    </message>
    <message>
        <source>Mirror blueprint</source>
        <translation>Reflejar plano</translation>
    </message>
    <message>
        <source>Anchors %1 and %2 look swapped: exchanged, the error falls from %3 to %4</source>
        <translation>Las anclas %1 y %2 parecen intercambiadas: al cambiarlas el error baja de %3 a %4</translation>
    </message>
    <message>
        <source>Swap %1 and %2</source>
        <translation>Intercambiar %1 y %2</translation>
    </message>
    <message>
        <source>Anchor %1 does not fit the others: they put it %2 away</source>
        <translation>El ancla %1 no encaja con las demás: la ponen a %2</translation>
    </message>
    <message>
        <source>The mesh folds near anchors %1 and %2: they pull against each other</source>
        <translation>La malla se pliega cerca de las anclas %1 y %2: tiran una contra otra</translation>
    </message>
    <message>
        <source>The mesh folds over itself: some anchors pull against each other</source>
        <translation>La malla se pliega sobre sí misma: algunas anclas tiran unas contra otras</translation>
    </message>
    <message>
        <source>The blueprint is %1 % too small for the SLAM map: its scale is wrong</source>
        <translation>El plano es un %1 % demasiado pequeño para el mapa SLAM: su escala está mal</translation>
    </message>
    <message>
        <source>The blueprint is %1 % too large for the SLAM map: its scale is wrong</source>
        <translation>El plano es un %1 % demasiado grande para el mapa SLAM: su escala está mal</translation>
    </message>
    <message>
        <source>Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %): check the scale of the blueprint</source>
        <translation>Plano %1 m, mapa SLAM %2 m entre las dos anclas (%3 %): revise la escala del plano</translation>
    </message>
    <message>
        <source>Anchors %1 and %2 are only %3 apart: add one far away, or the rotation stays a guess</source>
        <translation>Las anclas %1 y %2 distan solo %3: añada una lejos, o el giro será una conjetura</translation>
    </message>
    <message>
        <source>All anchors lie on one line: add one beside it, or the other direction stays a guess</source>
        <translation>Todas las anclas están en una línea: añada una al lado, o la otra dirección será una conjetura</translation>
    </message>
    <message>
        <source>All anchors are in one room: the rest of the building is a guess</source>
        <translation>Todas las anclas están en una sala: el resto del edificio es una conjetura</translation>
    </message>
    <message>
        <source>%1 of %2 rooms have no anchor yet</source>
        <translation>%1 de %2 salas aún no tienen ancla</translation>
    </message>
    <message>
        <source>A plain turn, shift and scale is enough here (%1 off in the middle): this SLAM map is not bent</source>
        <translation>Aquí basta girar, desplazar y escalar (%1 de error en el centro): este mapa SLAM no está deformado</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie beside the blueprint: %1</source>
        <translation>
            <numerusform>%n ancla está fuera del plano: %1</numerusform>
            <numerusform>%n anclas están fuera del plano: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie beside the SLAM map: %1</source>
        <translation>
            <numerusform>%n ancla está fuera del mapa SLAM: %1</numerusform>
            <numerusform>%n anclas están fuera del mapa SLAM: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Desactivar</translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie where the blueprint shows neither floor nor wall: %1</source>
        <translation>
            <numerusform>%n ancla está donde el plano no muestra ni suelo ni pared: %1</numerusform>
            <numerusform>%n anclas están donde el plano no muestra ni suelo ni pared: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie where the SLAM map shows neither floor nor wall: %1</source>
        <translation>
            <numerusform>%n ancla está donde el mapa SLAM no muestra ni suelo ni pared: %1</numerusform>
            <numerusform>%n anclas están donde el mapa SLAM no muestra ni suelo ni pared: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Show a good place</source>
        <translation>Mostrar un buen lugar</translation>
    </message>
    <message>
        <source>Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %): the scale of the blueprint fits</source>
        <translation>Plano %1 m, mapa SLAM %2 m entre las dos anclas (%3 %): la escala del plano concuerda</translation>
    </message>
    <message>
        <source>The anchors do not predict each other: without itself, one is typically %1 off. Some are misplaced, or more are needed between them</source>
        <translation>Las anclas no se predicen entre sí: sin ella misma, una queda normalmente a %1. Algunas están mal puestas, o faltan más entre ellas</translation>
    </message>
    <message>
        <source>After half a turn the anchors would fit as well: make sure that the SLAM map is the right way round, and add an anchor that has none opposite</source>
        <translation>Tras media vuelta las anclas encajarían igual: compruebe que el mapa SLAM está bien orientado y añada un ancla que no tenga otra enfrente</translation>
    </message>
    <message>
        <source>This SLAM map is %1 % too large: %2 agrees with the blueprint</source>
        <translation>Este mapa SLAM es un %1 % demasiado grande: %2 concuerda con el plano</translation>
    </message>
    <message>
        <source>This SLAM map is %1 % too small: %2 agrees with the blueprint</source>
        <translation>Este mapa SLAM es un %1 % demasiado pequeño: %2 concuerda con el plano</translation>
    </message>
    <message>
        <source>Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %), but %4 agrees with the blueprint: check the two anchors, or this SLAM map is not to scale</source>
        <translation>Plano %1 m, mapa SLAM %2 m entre las dos anclas (%3 %), pero %4 concuerda con el plano: revise las dos anclas, o este mapa SLAM no está a escala</translation>
    </message>
</context>
<context>
    <name>cad2slam::ExportDialog</name>
    <message>
        <source>Also write the blueprint as a &amp;map in the robot's frame (YAML and PNG)</source>
        <translation>Escribir también el plano como &amp;mapa en el sistema del robot (YAML y PNG)</translation>
    </message>
    <message>
        <source>&amp;Solve again</source>
        <translation>&amp;Resolver otra vez</translation>
    </message>
    <message>
        <source>Export projector</source>
        <translation>Exportar proyector</translation>
    </message>
    <message>
        <source>There is nothing to export yet</source>
        <translation>Aún no hay nada que exportar</translation>
    </message>
    <message>
        <source>The projector can be written, but look at this first</source>
        <translation>El proyector se puede escribir, pero mire esto primero</translation>
    </message>
    <message>
        <source>Ready to export</source>
        <translation>Listo para exportar</translation>
    </message>
    <message>
        <source>Export &amp;anyway...</source>
        <translation>Exportar &amp;igualmente...</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportar...</translation>
    </message>
    <message>
        <source>The warnings are written into the file.</source>
        <translation>Los avisos se escriben en el archivo.</translation>
    </message>
</context>
<context>
    <name>cad2slam::Exports</name>
    <message>
        <source>The blueprint as a map is in %1</source>
        <translation>El plano como mapa está en %1</translation>
    </message>
    <message>
        <source>Drawing the blueprint as a map…</source>
        <translation>Dibujando el plano como mapa…</translation>
    </message>
    <message>
        <source>Whether it fits the images of this project is not known</source>
        <translation>No se sabe si corresponde a las imágenes de este proyecto</translation>
    </message>
    <message>
        <source>It was made from the images that are shown here</source>
        <translation>Se hizo con las imágenes que se muestran aquí</translation>
    </message>
    <message>
        <source>To SLAM map &quot;%1&quot;: %2 nodes, %3 anchors; from project %4, %5, by %6</source>
        <translation>Al mapa SLAM «%1»: %2 nodos, %3 anclas; del proyecto %4, %5, por %6</translation>
    </message>
    <message>
        <source>The last solve was stopped, so there is nothing current to export</source>
        <translation>La última resolución se detuvo, así que no hay nada actual que exportar</translation>
    </message>
    <message>
        <source>An image is missing, or still being read</source>
        <translation>Falta una imagen o todavía se está leyendo</translation>
    </message>
    <message>
        <source>There is no alignment yet: place anchors first</source>
        <translation>Aún no hay alineación: ponga anclas primero</translation>
    </message>
    <message>
        <source>The alignment is still being computed: wait for the green chip</source>
        <translation>La alineación aún se calcula: espere al indicador verde</translation>
    </message>
    <message>
        <source>The last solve failed, so there is nothing current to export</source>
        <translation>La última resolución falló, así que no hay nada actual que exportar</translation>
    </message>
    <message>
        <source>Only %1 anchors are used: the map is not bent to fit; 4 or more are needed for checked results</source>
        <translation>Solo se usan %1 anclas: el mapa no se deforma; hacen falta 4 o más para resultados comprobados</translation>
    </message>
    <message>
        <source>%1 anchors are used, RMS of the residuals %2</source>
        <translation>Se usan %1 anclas, RMS de los residuos %2</translation>
    </message>
    <message>
        <source>These anchors fit badly: %1</source>
        <translation>Estas anclas encajan mal: %1</translation>
    </message>
    <message>
        <source>The mesh folds over itself in %1 places: no answer is given there</source>
        <translation>La malla se pliega en %1 lugares: allí no hay respuesta</translation>
    </message>
    <message>
        <source>The mesh does not fold</source>
        <translation>La malla no se pliega</translation>
    </message>
    <message>
        <source>The optimisation stopped before it had converged</source>
        <translation>La optimización se detuvo antes de converger</translation>
    </message>
    <message>
        <source>One half anchor is still waiting for its counterpart and is left out</source>
        <translation>Media ancla aún espera su contraparte y queda fuera</translation>
    </message>
    <message>
        <source>Choose a SLAM map first: anchors belong to one</source>
        <translation>Elija primero un mapa SLAM: las anclas pertenecen a uno</translation>
    </message>
    <message numerus="yes">
        <source>import %n anchor(s)</source>
        <translation>
            <numerusform>importar %n ancla</numerusform>
            <numerusform>importar %n anclas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) imported</source>
        <translation>
            <numerusform>%n ancla importada</numerusform>
            <numerusform>%n anclas importadas</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>línea %1: %2</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Omitidas: %1</translation>
    </message>
    <message numerus="yes">
        <source> and %n more</source>
        <translation>
            <numerusform> y %n más</numerusform>
            <numerusform> y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Anchors written to %1</source>
        <translation>Anclas escritas en %1</translation>
    </message>
    <message>
        <source>Projector written to %1, read again and compared at %2 places</source>
        <translation>Proyector escrito en %1, leído de nuevo y comparado en %2 lugares</translation>
    </message>
    <message>
        <source>an unknown date</source>
        <translation>fecha desconocida</translation>
    </message>
    <message>
        <source>(not saved)</source>
        <translation>(sin guardar)</translation>
    </message>
    <message>
        <source>Exported in spite of: %1</source>
        <translation>Exportado a pesar de: %1</translation>
    </message>
    <message>
        <source>Its blueprint is not the image of this project</source>
        <translation>Su plano no es la imagen de este proyecto</translation>
    </message>
    <message>
        <source>Its SLAM map is not the one being edited</source>
        <translation>Su mapa SLAM no es el que se edita</translation>
    </message>
    <message>
        <source>Import anchors</source>
        <translation>Importar anclas</translation>
    </message>
    <message>
        <source>Export anchors</source>
        <translation>Exportar anclas</translation>
    </message>
    <message>
        <source>Anchors (*.csv)</source>
        <translation>Anclas (*.csv)</translation>
    </message>
    <message>
        <source>Export projector</source>
        <translation>Exportar proyector</translation>
    </message>
    <message>
        <source>Projectors (*.c2s)</source>
        <translation>Proyectores (*.c2s)</translation>
    </message>
    <message>
        <source>Inspect a projector</source>
        <translation>Inspeccionar un proyector</translation>
    </message>
    <message>
        <source>Projectors (*.c2s);;All files (*)</source>
        <translation>Proyectores (*.c2s);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocida</translation>
    </message>
    <message>
        <source>SHA-256 of the images: blueprint %1, SLAM map %2</source>
        <translation>SHA-256 de las imágenes: plano %1, mapa SLAM %2</translation>
    </message>
    <message>
        <source>Solving the alignment from nothing…</source>
        <translation>Calculando la alineación desde cero…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>read as the SLAM map bent onto the blueprint</source>
        <translation>leídos como el mapa SLAM deformado sobre el plano</translation>
    </message>
    <message>
        <source>read as the blueprint bent onto the SLAM map</source>
        <translation>leídos como el plano deformado sobre el mapa SLAM</translation>
    </message>
    <message>
        <source>Anchors (*.csv *.txt *.data *.points);;All files (*)</source>
        <translation>Anclas (*.csv *.txt *.data *.points);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The blueprint is not the image this project was made with</source>
        <translation>El plano no es la imagen con la que se hizo este proyecto</translation>
    </message>
    <message>
        <source>The SLAM map is not the image this project was made with</source>
        <translation>El mapa SLAM no es la imagen con la que se hizo este proyecto</translation>
    </message>
    <message>
        <source>Without itself, an anchor is typically %1 off; %2 anchors are used, RMS of the residuals %3</source>
        <translation>Sin ella misma, un ancla queda normalmente a %1; se usan %2 anclas, RMS de los residuos %3</translation>
    </message>
    <message>
        <source>The project has changes that are not saved</source>
        <translation>El proyecto tiene cambios sin guardar</translation>
    </message>
</context>
<context>
    <name>cad2slam::MainWindow</name>
    <message>
        <source>Blueprint</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>SLAM map</source>
        <translation>Mapa SLAM</translation>
    </message>
    <message>
        <source>SLAM map being edited</source>
        <translation>Mapa SLAM en edición</translation>
    </message>
    <message>
        <source>SLAM map being edited; each has its own anchors</source>
        <translation>Mapa SLAM en edición; cada uno tiene sus anclas</translation>
    </message>
    <message>
        <source>Anchors</source>
        <translation>Anclas</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Rename SLAM map</source>
        <translation>Renombrar mapa SLAM</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>There is already a SLAM map %1</source>
        <translation>Ya existe un mapa SLAM %1</translation>
    </message>
    <message>
        <source>What you see is the last good result</source>
        <translation>Lo que ve es el último resultado bueno</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Proyecto nuevo</translation>
    </message>
    <message>
        <source>%1  x %2 m  y %3 m   pixel %4</source>
        <translation>%1  x %2 m  y %3 m   píxel %4</translation>
    </message>
    <message>
        <source>Drop the blueprint here, or click to choose it:
a map YAML, PNG, JPG, PGM or TIFF</source>
        <translation>Suelte aquí el plano o haga clic para elegirlo:
YAML de mapa, PNG, JPG, PGM o TIFF</translation>
    </message>
    <message>
        <source>Drop the SLAM map here, or click to choose it:
a map YAML, PGM, PNG or TIFF</source>
        <translation>Suelte aquí el mapa SLAM o haga clic para elegirlo:
YAML de mapa, PGM, PNG o TIFF</translation>
    </message>
    <message>
        <source>Loading...</source>
        <translation>Cargando...</translation>
    </message>
    <message>
        <source>This image cannot be shown: see the message above</source>
        <translation>Esta imagen no se puede mostrar: vea el mensaje de arriba</translation>
    </message>
    <message>
        <source>solving, step %1</source>
        <translation>resolviendo, paso %1</translation>
    </message>
</context>
<context>
    <name>cad2slam::MapView</name>
    <message>
        <source>Map view</source>
        <translation>Vista de mapa</translation>
    </message>
    <message>
        <source>Residuals drawn %1 times as long</source>
        <translation>Residuos dibujados %1 veces más largos</translation>
    </message>
    <message>
        <source>Reading the image, %1 %</source>
        <translation>Leyendo la imagen, %1 %</translation>
    </message>
</context>
<context>
    <name>cad2slam::MessageBar</name>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Show fewer</source>
        <translation>Mostrar menos</translation>
    </message>
    <message numerus="yes">
        <source>%n more message(s)</source>
        <translation>
            <numerusform>%n mensaje más</numerusform>
            <numerusform>%n mensajes más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cad2slam::MessageRow</name>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
</context>
<context>
    <name>cad2slam::PreviewLegend</name>
    <message>
        <source>%1 %</source>
        <comment>per cent</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Mesh: length against rest</source>
        <translation>Malla: longitud frente al reposo</translation>
    </message>
    <message>
        <source>crosses: the mesh folds</source>
        <translation>cruces: la malla se pliega</translation>
    </message>
</context>
<context>
    <name>cad2slam::PreviewPanel</name>
    <message>
        <source>Overlay</source>
        <translation>Superposición</translation>
    </message>
    <message>
        <source>Two inks</source>
        <translation>Dos tintas</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>Cortina</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Parpadeo</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuos</translation>
    </message>
    <message>
        <source>Local scale</source>
        <translation>Escala local</translation>
    </message>
    <message>
        <source>Local turn</source>
        <translation>Giro local</translation>
    </message>
    <message>
        <source>All SLAM maps</source>
        <translation>Todos los mapas SLAM</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>How the maps are compared (O)</source>
        <translation>Cómo se comparan los mapas (O)</translation>
    </message>
    <message>
        <source>Preview mode</source>
        <translation>Modo de vista previa</translation>
    </message>
    <message>
        <source>How opaque the upper map is ([ and ])</source>
        <translation>Cuán opaco es el mapa de arriba ([ y ])</translation>
    </message>
    <message>
        <source>Which map lies below (Shift+O)</source>
        <translation>Qué mapa está debajo (Mayús+O)</translation>
    </message>
    <message>
        <source>Blink by itself</source>
        <translation>Parpadear solo</translation>
    </message>
    <message>
        <source>Change between the maps three times a second</source>
        <translation>Cambiar entre los mapas tres veces por segundo</translation>
    </message>
    <message>
        <source>Show the whole map (F)</source>
        <translation>Mostrar todo el mapa (F)</translation>
    </message>
    <message>
        <source>SLAM map on blueprint</source>
        <translation>Mapa SLAM sobre plano</translation>
    </message>
    <message>
        <source>Blueprint on SLAM map</source>
        <translation>Plano sobre mapa SLAM</translation>
    </message>
    <message>
        <source>Distance to anchors</source>
        <translation>Distancia a las anclas</translation>
    </message>
</context>
<context>
    <name>cad2slam::PreviewView</name>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Overlay, %1 %</source>
        <translation>Superposición, %1 %</translation>
    </message>
    <message>
        <source>Two inks</source>
        <translation>Dos tintas</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>Cortina</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Parpadeo</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>Local scale against the mean</source>
        <translation>Escala local frente a la media</translation>
    </message>
    <message>
        <source>Local turn against the mean</source>
        <translation>Giro local frente a la media</translation>
    </message>
    <message>
        <source>All SLAM maps</source>
        <translation>Todos los mapas SLAM</translation>
    </message>
    <message>
        <source>[ and ] change it, hold B to hide it</source>
        <translation>[ y ] la cambian, mantener B la oculta</translation>
    </message>
    <message>
        <source>Drag the bar</source>
        <translation>Arrastre la barra</translation>
    </message>
    <message>
        <source>Hold B for the other map</source>
        <translation>Mantenga B para el otro mapa</translation>
    </message>
    <message>
        <source>Dark: both agree</source>
        <translation>Oscuro: ambos coinciden</translation>
    </message>
    <message>
        <source>left: %1</source>
        <translation>izquierda: %1</translation>
    </message>
    <message>
        <source>right: %1</source>
        <translation>derecha: %1</translation>
    </message>
    <message>
        <source>around: %1</source>
        <translation>alrededor: %1</translation>
    </message>
    <message>
        <source>in the lens: %1</source>
        <translation>en la lente: %1</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 sobre %2</translation>
    </message>
    <message>
        <source>good</source>
        <translation>buena</translation>
    </message>
    <message>
        <source>worth a look</source>
        <translation>por revisar</translation>
    </message>
    <message>
        <source>probably wrong</source>
        <translation>probablemente mala</translation>
    </message>
    <message>
        <source>black: the mesh folds</source>
        <translation>negro: la malla se pliega</translation>
    </message>
    <message>
        <source>°</source>
        <comment>degrees</comment>
        <translation>°</translation>
    </message>
    <message>
        <source> %</source>
        <comment>per cent</comment>
        <translation> %</translation>
    </message>
    <message>
        <source>Residuals, %1 times as long</source>
        <translation>Residuos, %1 veces más largos</translation>
    </message>
    <message>
        <source>From the projected to the clicked place</source>
        <translation>Del lugar proyectado al lugar marcado</translation>
    </message>
    <message>
        <source>Distance to the nearest anchor</source>
        <translation>Distancia al ancla más cercana</translation>
    </message>
    <message>
        <source>Anchors help most where it is red</source>
        <translation>Rojo: aquí es donde más ayuda un ancla</translation>
    </message>
    <message>
        <source> m</source>
        <comment>metres</comment>
        <translation> m</translation>
    </message>
</context>
<context>
    <name>cad2slam::PreviewWiring</name>
    <message>
        <source>Load a blueprint and a SLAM map to see them over each other</source>
        <translation>Cargue un plano y un mapa SLAM para verlos superpuestos</translation>
    </message>
    <message>
        <source>Load a blueprint and a SLAM map first</source>
        <translation>Cargue primero un plano y un mapa SLAM</translation>
    </message>
    <message>
        <source>Nothing to lay over it yet: place an anchor in both views</source>
        <translation>Aún no hay nada que superponer: ponga un ancla en ambas vistas</translation>
    </message>
    <message>
        <source>Solving...</source>
        <translation>Resolviendo...</translation>
    </message>
    <message>
        <source>Not current: the last solve failed, this is the result before it</source>
        <translation>No actual: la última resolución falló, este es el resultado anterior</translation>
    </message>
    <message>
        <source>Not current: the last solve was stopped</source>
        <translation>No actual: la última resolución se detuvo</translation>
    </message>
    <message>
        <source>Rough: one anchor says nothing of the turn</source>
        <translation>Aproximado: un ancla no dice nada del giro</translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>%1 (no anchors)</source>
        <translation>%1 (sin anclas)</translation>
    </message>
    <message>
        <source>%1 (solving...)</source>
        <translation>%1 (resolviendo...)</translation>
    </message>
    <message>
        <source>%1 (cannot be solved)</source>
        <translation>%1 (no se puede resolver)</translation>
    </message>
    <message>
        <source>%1 (stopped)</source>
        <translation>%1 (detenido)</translation>
    </message>
    <message>
        <source>Loading the images...</source>
        <translation>Cargando las imágenes...</translation>
    </message>
</context>
<context>
    <name>cad2slam::ProjectFiles</name>
    <message>
        <source>Project changed on disk</source>
        <translation>Proyecto modificado en el disco</translation>
    </message>
    <message>
        <source>%1 was saved by another program after it was opened here.</source>
        <translation>Otro programa guardó %1 después de que se abriera aquí.</translation>
    </message>
    <message>
        <source>To replace it loses what was done there.</source>
        <translation>Si se reemplaza, se pierde lo que se hizo allí.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>One anchor has only one half: click its counterpart, or press Esc to drop it</source>
        <translation>Un ancla tiene solo una mitad: haga clic en su contraparte o pulse Esc para soltarla</translation>
    </message>
    <message>
        <source>Save elsewhere...</source>
        <translation>Guardar en otro lugar...</translation>
    </message>
    <message>
        <source>Saved, with one half of an anchor still waiting for its counterpart</source>
        <translation>Guardado, con media ancla que aún espera su contraparte</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Guardado</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Abrir proyecto</translation>
    </message>
    <message>
        <source>Projects (*.c2sproj);;All files (*)</source>
        <translation>Proyectos (*.c2sproj);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message>
        <source>Projects (*.c2sproj)</source>
        <translation>Proyectos (*.c2sproj)</translation>
    </message>
    <message>
        <source>Choose the blueprint</source>
        <translation>Elegir el plano</translation>
    </message>
    <message>
        <source>Add a SLAM map</source>
        <translation>Añadir un mapa SLAM</translation>
    </message>
    <message>
        <source>Maps and images (*.yaml *.yml *.png *.pgm *.jpg *.jpeg *.tif *.tiff *.bmp);;All files (*)</source>
        <translation>Mapas e imágenes (*.yaml *.yml *.png *.pgm *.jpg *.jpeg *.tif *.tiff *.bmp);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>The project has changes that are not saved.</source>
        <translation>El proyecto tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Save them before it is closed?</source>
        <translation>¿Guardarlos antes de cerrar?</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Ninguno aún</translation>
    </message>
    <message>
        <source>Find it...</source>
        <translation>Buscar...</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>¿Dónde está %1?</translation>
    </message>
    <message>
        <source>Use this one</source>
        <translation>Usar esta</translation>
    </message>
</context>
<context>
    <name>cad2slam::RasterStore</name>
    <message>
        <source>%1 is not the image this project was made with; check that the anchors still fit</source>
        <translation>%1 no es la imagen con la que se hizo este proyecto; compruebe que las anclas aún encajan</translation>
    </message>
</context>
<context>
    <name>cad2slam::Recovery</name>
    <message>
        <source>Autosave does not work: %1</source>
        <translation>El guardado automático no funciona: %1</translation>
    </message>
    <message>
        <source>a project that was never saved</source>
        <translation>un proyecto que nunca se guardó</translation>
    </message>
    <message>
        <source>The program ended unexpectedly; %1 was last edited %2</source>
        <translation>El programa terminó de forma inesperada; %1 se editó por última vez el %2</translation>
    </message>
    <message>
        <source>What a program that ended unexpectedly has left of %1 cannot be read: %2</source>
        <translation>Lo que un programa terminado inesperadamente dejó de %1 no se puede leer: %2</translation>
    </message>
    <message>
        <source>It was saved again %1, so what is recovered will be a project of its own</source>
        <translation>Se volvió a guardar el %1, así que lo recuperado será un proyecto aparte</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Images: %1; anchors: %2</source>
        <translation>Imágenes: %1; anclas: %2</translation>
    </message>
</context>
<context>
    <name>cad2slam::ScaleDialog</name>
    <message>
        <source>Scale of the blueprint</source>
        <translation>Escala del plano</translation>
    </message>
    <message>
        <source>Scale of the SLAM map</source>
        <translation>Escala del mapa SLAM</translation>
    </message>
    <message>
        <source>%1 does not tell its scale. Type it, or click both ends of something whose length you know and type that length.</source>
        <translation>%1 no dice su escala. Escríbala, o haga clic en ambos extremos de algo cuya longitud conozca y escriba esa longitud.</translation>
    </message>
    <message>
        <source>Line drawn:</source>
        <translation>Línea dibujada:</translation>
    </message>
    <message>
        <source>Its &amp;length (m):</source>
        <translation>Su &amp;longitud (m):</translation>
    </message>
    <message>
        <source>&amp;Metres for each pixel:</source>
        <translation>&amp;Metros por píxel:</translation>
    </message>
    <message>
        <source>Size of the picture:</source>
        <translation>Tamaño de la imagen:</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 píxeles</translation>
    </message>
    <message>
        <source>click one end</source>
        <translation>haga clic en un extremo</translation>
    </message>
    <message>
        <source>click the other end</source>
        <translation>haga clic en el otro extremo</translation>
    </message>
    <message>
        <source>%1 m x %2 m at %3 m for each pixel</source>
        <translation>%1 m x %2 m a %3 m por píxel</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>aún no se conoce</translation>
    </message>
    <message>
        <source>for example %1</source>
        <translation>por ejemplo %1</translation>
    </message>
</context>
<context>
    <name>cad2slam::SettingsDialog</name>
    <message>
        <source>An anchor is judged by the error without it, from four anchors on. The larger of a length and a number of SLAM map pixels counts. When most anchors are beyond the last limit, a message says so. These limits are kept in the project.</source>
        <translation>A partir de cuatro anclas, un ancla se juzga por el error sin ella. Cuenta el mayor de una longitud y un número de píxeles del mapa SLAM. Si la mayoría de las anclas están fuera del último límite, un mensaje lo dice. Estos límites se guardan en el proyecto.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>&amp;Alignment</source>
        <translation>&amp;Alineación</translation>
    </message>
    <message>
        <source>&amp;Limits</source>
        <translation>&amp;Límites</translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation>A&amp;pariencia</translation>
    </message>
    <message>
        <source>&amp;Defaults of the model</source>
        <translation>Valores &amp;predeterminados del modelo</translation>
    </message>
    <message>
        <source>Stretch: bends and stretches (recommended)</source>
        <translation>Estirar: dobla y estira (recomendado)</translation>
    </message>
    <message>
        <source>Rigid: bends only, as in the paper</source>
        <translation>Rígido: solo dobla, como en el artículo</translation>
    </message>
    <message>
        <source>&amp;Model:</source>
        <translation>&amp;Modelo:</translation>
    </message>
    <message>
        <source>The plan is to scale</source>
        <translation>El plano está a escala</translation>
    </message>
    <message>
        <source>Unknown: find it from the anchors</source>
        <translation>Desconocida: hallarla con las anclas</translation>
    </message>
    <message>
        <source>A number I know</source>
        <translation>Un número que conozco</translation>
    </message>
    <message>
        <source>&amp;Scale of the blueprint:</source>
        <translation>&amp;Escala del plano:</translation>
    </message>
    <message>
        <source>SLAM metres per blueprint metre:</source>
        <translation>Metros SLAM por metro de plano:</translation>
    </message>
    <message>
        <source>1 where both are true to scale</source>
        <translation>1 donde ambos están a escala</translation>
    </message>
    <message>
        <source>&amp;Cell size of the mesh (m):</source>
        <translation>Tamaño de &amp;celda de la malla (m):</translation>
    </message>
    <message>
        <source>Smaller follows finer bends and takes longer</source>
        <translation>Menor sigue dobleces más finos y tarda más</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>Pull of an anchor:</source>
        <translation>Tirón de un ancla:</translation>
    </message>
    <message>
        <source>Larger trusts the clicks more</source>
        <translation>Mayor confía más en los clics</translation>
    </message>
    <message>
        <source>Bad anchors start at (m):</source>
        <translation>Anclas malas desde (m):</translation>
    </message>
    <message>
        <source>An anchor off by more than this loses its pull; empty trusts every anchor</source>
        <translation>Un ancla que yerra más pierde su tirón; vacío confía en todas</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nunca</translation>
    </message>
    <message>
        <source>Stiffness along an edge:</source>
        <translation>Rigidez a lo largo de una arista:</translation>
    </message>
    <message>
        <source>Stiffness across an edge:</source>
        <translation>Rigidez a través de una arista:</translation>
    </message>
    <message>
        <source>Stiffness of bending:</source>
        <translation>Rigidez a la flexión:</translation>
    </message>
    <message>
        <source>Empty follows the size of the building</source>
        <translation>Vacío sigue el tamaño del edificio</translation>
    </message>
    <message>
        <source>Smoothness of the stretch:</source>
        <translation>Suavidad del estiramiento:</translation>
    </message>
    <message>
        <source>Resistance to stretch:</source>
        <translation>Resistencia al estiramiento:</translation>
    </message>
    <message>
        <source>● OK up to (m):</source>
        <translation>● OK hasta (m):</translation>
    </message>
    <message>
        <source>● OK up to (pixels):</source>
        <translation>● OK hasta (píxeles):</translation>
    </message>
    <message>
        <source>◆ Have a look up to (m):</source>
        <translation>◆ Revisar hasta (m):</translation>
    </message>
    <message>
        <source>◆ Have a look up to (pixels):</source>
        <translation>◆ Revisar hasta (píxeles):</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>High contrast, for sunlight</source>
        <translation>Alto contraste, para el sol</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Colores:</translation>
    </message>
    <message>
        <source>&amp;Language (from the next start):</source>
        <translation>&amp;Idioma (desde el próximo inicio):</translation>
    </message>
    <message>
        <source>The fields with a frame need a number above zero that a project can hold</source>
        <translation>Los campos con marco necesitan un número mayor que cero que quepa en un proyecto</translation>
    </message>
    <message>
        <source>Automatic: what predicts the anchors best (recommended)</source>
        <translation>Automática: la que mejor predice las anclas (recomendada)</translation>
    </message>
    <message>
        <source>Loose: clicks that are noisier than the map is bent</source>
        <translation>Suelta: clics más imprecisos que la deformación del mapa</translation>
    </message>
    <message>
        <source>Smooth: halls that bend as a whole</source>
        <translation>Suave: naves que se doblan enteras</translation>
    </message>
    <message>
        <source>Local: corridors that drifted each by themselves</source>
        <translation>Local: pasillos que derivaron cada uno por su cuenta</translation>
    </message>
    <message>
        <source>The numbers below</source>
        <translation>Los números de abajo</translation>
    </message>
    <message>
        <source>S&amp;tiffness:</source>
        <translation>&amp;Rigidez:</translation>
    </message>
</context>
<context>
    <name>cad2slam::TestPoses</name>
    <message>
        <source>%1 (extrapolated)</source>
        <translation>%1 (extrapolado)</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>meta</translation>
    </message>
    <message>
        <source>start</source>
        <translation>inicio</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Place anchors first, then the robot shows in both views</source>
        <translation>Ponga anclas primero; entonces el robot aparece en ambas vistas</translation>
    </message>
    <message>
        <source>The mesh folds here: there is no answer</source>
        <translation>La malla se pliega aquí: no hay respuesta</translation>
    </message>
    <message>
        <source>There is no answer at this place</source>
        <translation>No hay respuesta en este lugar</translation>
    </message>
    <message>
        <source>%1SLAM map x %2 m, y %3 m, heading %4°; there and back differs by %5 mm, %6°</source>
        <translation>%1Mapa SLAM x %2 m, y %3 m, rumbo %4°; ida y vuelta difiere %5 mm, %6°</translation>
    </message>
    <message>
        <source>Extrapolated: </source>
        <translation>Extrapolado: </translation>
    </message>
</context>
<context>
    <name>cad2slam::TilePyramid</name>
    <message>
        <source>The image %1 could not be read: %2</source>
        <translation>No se pudo leer la imagen %1: %2</translation>
    </message>
</context>
<context>
    <name>cad2slam::Tips</name>
    <message>
        <source>O shows the next way to compare the maps; hold B to see one map alone</source>
        <translation>O muestra la siguiente forma de comparar los mapas; con B pulsada se ve un solo mapa</translation>
    </message>
    <message>
        <source>N goes to the anchor with the largest error, and shows it in both views</source>
        <translation>N va al ancla con el mayor error y la muestra en ambas vistas</translation>
    </message>
    <message>
        <source>R shows a robot to drag: where it is in one map, and where in the other</source>
        <translation>R muestra un robot para arrastrar: dónde está en un mapa y dónde en el otro</translation>
    </message>
    <message>
        <source>F1 shows all keys</source>
        <translation>F1 muestra todas las teclas</translation>
    </message>
    <message>
        <source>Tip: %1</source>
        <translation>Consejo: %1</translation>
    </message>
    <message>
        <source>No more tips</source>
        <translation>No más consejos</translation>
    </message>
    <message>
        <source>Arrow keys move the selected anchor by one pixel; hold Z to see it four times larger</source>
        <translation>Las flechas mueven el ancla elegida un píxel; con Z pulsada se ve cuatro veces ampliado</translation>
    </message>
</context>
<context>
    <name>cad2slam::Tour</name>
    <message>
        <source>The sample building is not installed; drop your own two maps into the views</source>
        <translation>El edificio de ejemplo no está instalado; arrastre sus dos mapas a las vistas</translation>
    </message>
    <message>
        <source>On the left the plan of an office, on the right what a robot has mapped. Click a corner of a room in the plan; the wheel zooms, dragging moves</source>
        <translation>A la izquierda el plano de una oficina, a la derecha lo que un robot ha cartografiado. Haga clic en una esquina de una sala del plano; la rueda amplía, arrastrar mueve</translation>
    </message>
    <message>
        <source>Now find the same corner on the right and click it. Holding Z magnifies</source>
        <translation>Ahora busque la misma esquina a la derecha y haga clic. Mantener Z amplía</translation>
    </message>
    <message>
        <source>That is an anchor. Make a second one far away from it</source>
        <translation>Eso es un ancla. Ponga otra lejos de ella</translation>
    </message>
    <message>
        <source>From four anchors on each is checked by the others: see &quot;Without it&quot; in the table. The preview shows both maps together, O changes how</source>
        <translation>Desde cuatro anclas cada una se comprueba con las demás: vea «Sin ella» en la tabla. La vista previa muestra ambos mapas juntos, O cambia cómo</translation>
    </message>
    <message>
        <source>More anchors where the preview is off make it better; Ctrl+E writes the file for the robots</source>
        <translation>Más anclas donde la vista previa no encaje lo mejoran; Ctrl+E escribe el archivo para los robots</translation>
    </message>
    <message>
        <source>Step %1 of %2. %3</source>
        <translation>Paso %1 de %2. %3</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>From now on the other half is predicted: after the first click a blue mark shows it. Enter takes it, a click elsewhere corrects it. Make four anchors</source>
        <translation>Desde ahora se predice la otra mitad: tras el primer clic la muestra una marca azul. Intro la toma, un clic en otro lugar la corrige. Ponga cuatro anclas</translation>
    </message>
</context>
<context>
    <name>cad2slam::ViewPair</name>
    <message>
        <source>Click the same place here (Enter accepts, Esc cancels)</source>
        <translation>Haga clic aquí en el mismo lugar (Intro acepta, Esc cancela)</translation>
    </message>
    <message>
        <source>Now click the same place here (Esc cancels)</source>
        <translation>Ahora haga clic en el mismo lugar aquí (Esc cancela)</translation>
    </message>
    <message>
        <source>%1? Enter accepts</source>
        <translation>¿%1? Intro acepta</translation>
    </message>
</context>
<context>
    <name>edit</name>
    <message>
        <source>add anchor %1</source>
        <translation>añadir ancla %1</translation>
    </message>
    <message>
        <source>move anchor %1</source>
        <translation>mover ancla %1</translation>
    </message>
    <message>
        <source>type coordinates of anchor %1</source>
        <translation>escribir coordenadas del ancla %1</translation>
    </message>
    <message>
        <source>delete anchor %1</source>
        <translation>borrar ancla %1</translation>
    </message>
    <message>
        <source>delete %1 anchors</source>
        <translation>borrar %1 anclas</translation>
    </message>
    <message>
        <source>use anchors</source>
        <translation>usar anclas</translation>
    </message>
    <message>
        <source>disable anchors</source>
        <translation>apagar anclas</translation>
    </message>
    <message>
        <source>rename anchor %1</source>
        <translation>renombrar ancla %1</translation>
    </message>
    <message>
        <source>note on anchor %1</source>
        <translation>nota del ancla %1</translation>
    </message>
    <message>
        <source>swap anchors %1 and %2</source>
        <translation>intercambiar anclas %1 y %2</translation>
    </message>
    <message>
        <source>SLAM map</source>
        <translation>Mapa SLAM</translation>
    </message>
    <message>
        <source>choose blueprint</source>
        <translation>elegir plano</translation>
    </message>
    <message>
        <source>rescale blueprint</source>
        <translation>reescalar plano</translation>
    </message>
    <message>
        <source>mirror blueprint</source>
        <translation>reflejar plano</translation>
    </message>
    <message>
        <source>change settings</source>
        <translation>cambiar ajustes</translation>
    </message>
    <message>
        <source>add SLAM map</source>
        <translation>añadir mapa SLAM</translation>
    </message>
    <message>
        <source>remove SLAM map</source>
        <translation>quitar mapa SLAM</translation>
    </message>
    <message>
        <source>rename SLAM map</source>
        <translation>renombrar mapa SLAM</translation>
    </message>
    <message>
        <source>choose SLAM map</source>
        <translation>elegir mapa SLAM</translation>
    </message>
</context>
<context>
    <name>units</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
</TS>
